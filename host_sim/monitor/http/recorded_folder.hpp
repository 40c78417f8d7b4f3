#pragma once

#include <filesystem>
#include <functional>
#include <utility>

#include "host_sim/monitor/http/frame_archive.hpp"

namespace host_sim::monitor {

/// The frames that a Recorder writes to its folder. What is seen while they are read may be there
/// or not, but lines are whole; a log that is removed meanwhile is left out.
class RecordedFolder final : public FrameArchive {
 public:
  /// `flush` has what was seen before written to the folder; called before it is read.
  RecordedFolder(std::filesystem::path folder, std::function<void()> flush)
      : folder_(std::move(folder)), flush_(std::move(flush)) {}

  void read(std::optional<protocol::Node> node,
            const std::function<bool(std::string_view)>& take) const override;

 private:
  std::filesystem::path folder_;
  std::function<void()> flush_;
};

}  // namespace host_sim::monitor
