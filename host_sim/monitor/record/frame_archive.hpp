#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "firmware/protocol/messages.hpp"
#include "host_sim/monitor/fleet/watch.hpp"

namespace host_sim::monitor {

/// Frames that were seen, for export and for looking back.
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
  /// The same of all nodes, from a line on that is seldom much earlier than `from_us`, and later
  /// only where the oldest is.
  virtual void read_from(std::int64_t from_us,
                         const std::function<bool(std::string_view)>& take) const = 0;
  /// Times of lines that are spread through the archive, about as many bytes apart, rising,
  /// kMostTimes at most; the first is that of the oldest line. Where a clock was set back, of what
  /// came after it.
  [[nodiscard]] virtual std::vector<std::int64_t> times_us() const = 0;
  /// Why frames before the oldest are gone, for people; empty where none are.
  [[nodiscard]] virtual std::string why_gone() const = 0;

  static constexpr std::size_t kMostTimes = 512;
};

/// The newest frames, in memory: what there is of the past where nothing is recorded.
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
  void read_from(std::int64_t from_us,
                 const std::function<bool(std::string_view)>& take) const override;
  [[nodiscard]] std::vector<std::int64_t> times_us() const override;
  [[nodiscard]] std::string why_gone() const override;

 private:
  using Piece = std::shared_ptr<const std::string>;
  /// All that is kept, the oldest first.
  [[nodiscard]] std::vector<Piece> pieces() const;

  std::string interface_;
  std::size_t piece_;
  mutable std::mutex mutex_;
  std::deque<Piece> full_;
  std::string open_;
  bool gone_ = false;
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
  void read_from(std::int64_t from_us,
                 const std::function<bool(std::string_view)>& take) const override;
  [[nodiscard]] std::vector<std::int64_t> times_us() const override;
  [[nodiscard]] std::string why_gone() const override;

 private:
  std::filesystem::path folder_;
  std::function<void()> flush_;
};

/// The node that a line is of: sender, or whom it is meant for. None for frames that are not of the
/// plan.
[[nodiscard]] std::optional<protocol::Node> node_of_line(std::string_view line);

}  // namespace host_sim::monitor
