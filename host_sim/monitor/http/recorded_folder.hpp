#pragma once

#include <filesystem>
#include <utility>

#include "host_sim/monitor/http/frame_archive.hpp"

namespace host_sim::monitor {

/// The frames that a Recorder has written to its folder. What it writes while they are read may be
/// there or not, but lines are whole; a log that is removed meanwhile is left out.
class RecordedFolder final : public FrameArchive {
 public:
  explicit RecordedFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}

  void read(std::optional<protocol::Node> node,
            const std::function<bool(std::string_view)>& take) const override;

 private:
  std::filesystem::path folder_;
};

}  // namespace host_sim::monitor
