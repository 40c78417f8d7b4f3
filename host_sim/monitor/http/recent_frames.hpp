#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>
#include <string>

#include "host_sim/monitor/http/frame_archive.hpp"
#include "host_sim/monitor/watch/observer.hpp"

namespace host_sim::monitor {

/// The newest frames, in memory: what can be exported where nothing is recorded.
class RecentFrames final : public Observer, public FrameArchive {
 public:
  /// Bytes of lines: about 700,000 frames.
  static constexpr std::size_t kMost = std::size_t{32} << 20;

  /// `interface`: the name in the lines. The newest lines are kept, `most` bytes of them at most
  /// and about a thirty-second less at least, once there are so many; `most` 8 KiB or more.
  explicit RecentFrames(std::string interface, std::size_t most = kMost);

  void see(const SeenFrame& seen) override;
  void read(std::optional<protocol::Node> node,
            const std::function<bool(std::string_view)>& take) const override;

 private:
  std::string interface_;
  std::size_t piece_;
  mutable std::mutex mutex_;
  std::deque<std::shared_ptr<const std::string>> full_;
  std::string open_;
};

}  // namespace host_sim::monitor
