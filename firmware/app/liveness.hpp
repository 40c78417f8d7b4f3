#pragma once

#include <cstdint>

#include "hal/clock.hpp"

namespace app {

/// Whether the control loop runs, and whether it was late.
class Liveness {
 public:
  /// Without a period for so long the control loop is dead.
  static constexpr hal::Time kDead = hal::milliseconds(100);
  /// For so long after a missed period it counts as late.
  static constexpr hal::Time kLate = hal::seconds(10);

  void start(hal::Time now) { moved_ = now; }

  /// `periods` counts the periods of the loop and wraps.
  bool alive(hal::Time now, std::uint32_t periods) {
    if (periods != periods_) {
      periods_ = periods;
      moved_ = now;
    }
    return now < moved_ + kDead;
  }

  /// `missed` counts the periods that were left out and wraps.
  bool late(hal::Time now, std::uint32_t missed) {
    if (missed != missed_) {
      missed_ = missed;
      late_until_ = now + kLate;
    }
    return now < late_until_;
  }

 private:
  std::uint32_t periods_ = 0;
  std::uint32_t missed_ = 0;
  hal::Time moved_{};
  hal::Time late_until_{};
};

}  // namespace app
