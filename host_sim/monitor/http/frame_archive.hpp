#pragma once

#include <cstddef>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "firmware/protocol/messages.hpp"
#include "host_sim/monitor/fleet/watch.hpp"

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

/// The node that a line is of: sender, or whom it is meant for. None for frames that are not of the
/// plan.
[[nodiscard]] std::optional<protocol::Node> node_of_line(std::string_view line);

}  // namespace host_sim::monitor
