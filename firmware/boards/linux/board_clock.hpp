#pragma once

#include "hal/clock.hpp"
#include "hal/linux/monotonic_clock.hpp"

namespace board {

/// The clock of the machine, or a virtual one that only advance() moves.
class BoardClock {
 public:
  explicit BoardClock(bool is_virtual) : virtual_(is_virtual) {}

  [[nodiscard]] hal::Time now() const { return virtual_ ? now_ : machine_.now(); }
  void advance_to(hal::Time time) { now_ = time; }

 private:
  bool virtual_;
  hal::linux_os::MonotonicClock machine_;
  hal::Time now_{};
};
static_assert(hal::Clock<BoardClock>);

}  // namespace board
