#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

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
  /// In words: "can0", "can0 is down", "run1.log, at its end".
  [[nodiscard]] virtual std::string words() const = 0;
  /// The time of the clock that stamps the frames, now: what staleness is measured by.
  [[nodiscard]] virtual std::int64_t now_ns() const = 0;
};

}  // namespace host_sim::monitor
