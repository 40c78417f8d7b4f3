#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "host_sim/monitor/bus/frame_log.hpp"
#include "host_sim/monitor/bus/seen_frame.hpp"

namespace host_sim::monitor {

/// Where frames come from: an interface, or a log that is replayed.
class FrameSource {
 public:
  FrameSource() = default;
  FrameSource(const FrameSource&) = delete;
  FrameSource& operator=(const FrameSource&) = delete;
  virtual ~FrameSource() = default;

  enum class State : std::uint8_t {
    running,
    lost,   ///< the interface is down or gone; it is tried again
    ended,  ///< the log is at its end
  };

  /// The next frame, or none where none came within `most`, or the source is lost or at its end.
  /// @throws InputError for a line of a log that is no frame
  virtual std::optional<SeenFrame> next(std::chrono::milliseconds most) = 0;

  [[nodiscard]] virtual State state() const = 0;
  /// For people: "can0", "can0 is down", "run1.log, at its end".
  [[nodiscard]] virtual std::string description() const = 0;
  /// The time of the clock that stamps the frames, now: what staleness is measured by.
  [[nodiscard]] virtual std::int64_t now_ns() const = 0;
};

/// Replays a log at `speed` times the pace at which it was recorded; 0 is as fast as it goes. Time
/// is that of the log, and never falls: a frame that is earlier than the one before it has its
/// time.
class LogSource final : public FrameSource {
 public:
  LogSource(std::unique_ptr<LogReader> reader, std::string name, double speed);

  std::optional<SeenFrame> next(std::chrono::milliseconds most) override;
  [[nodiscard]] State state() const override;
  [[nodiscard]] std::string description() const override;
  [[nodiscard]] std::int64_t now_ns() const override;

 private:
  using Clock = std::chrono::steady_clock;

  void fill();
  [[nodiscard]] Clock::time_point due() const;

  std::unique_ptr<LogReader> reader_;
  std::string name_;
  double speed_;
  std::optional<SeenFrame> waiting_;
  std::int64_t begin_ns_ = 0;  ///< of the first frame
  std::int64_t last_ns_ = 0;   ///< of the last frame that was given
  Clock::time_point began_{};
  bool began_once_ = false;
  bool ended_ = false;
};

}  // namespace host_sim::monitor
