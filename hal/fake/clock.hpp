#pragma once

#include "hal/clock.hpp"

namespace hal::fake {

/// Virtual time: it stands still until somebody moves it, and never runs back.
class Clock {
 public:
  [[nodiscard]] constexpr Time now() const { return now_; }

  constexpr void advance(Time by) { now_ = now_ + by; }
  /// Does nothing where that time has passed.
  constexpr void advance_to(Time time) { now_ = time > now_ ? time : now_; }

 private:
  Time now_{};
};

static_assert(hal::Clock<Clock>);

}  // namespace hal::fake
