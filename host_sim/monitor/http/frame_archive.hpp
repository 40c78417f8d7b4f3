#pragma once

#include <functional>
#include <optional>
#include <string_view>

#include "firmware/protocol/messages.hpp"

namespace host_sim::monitor {

/// Frames that were seen, for export.
class FrameArchive {
 public:
  FrameArchive() = default;
  FrameArchive(const FrameArchive&) = delete;
  FrameArchive& operator=(const FrameArchive&) = delete;
  virtual ~FrameArchive() = default;

  /// Hands the lines of `candump -L`, with their ends, to `take`, oldest first, in pieces of whole
  /// lines; all, or those of `node` alone. Stops where `take` says false. Called by several threads
  /// at once, while frames are recorded.
  virtual void read(std::optional<protocol::Node> node,
                    const std::function<bool(std::string_view)>& take) const = 0;
};

}  // namespace host_sim::monitor
