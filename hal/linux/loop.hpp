#pragma once

#include <time.h>

#include <atomic>
#include <cstdint>

#include "hal/linux/jitter.hpp"
#include "hal/linux/monotonic_clock.hpp"
#include "hal/linux/schedule.hpp"

namespace hal::linux_os {

/// The clock that a loop waits on. A test puts a scripted one in this place.
struct WaitingClock {
  [[nodiscard]] std::int64_t now_ns() const { return monotonic_ns(); }
  /// Waits until this time, or less where a signal comes.
  void wait_until(std::int64_t time_ns) const {
    const ::timespec time{static_cast<time_t>(time_ns / 1'000'000'000),
                          static_cast<long>(time_ns % 1'000'000'000)};
    ::clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &time, nullptr);
  }
};

/// Calls tick(missed) once a period, at absolute times, until `stop` is set or it returns false.
/// `missed` counts the periods that passed without a call since the last one; they are not caught
/// up.
template <class ClockT, class Tick>
void run_periodic(ClockT& clock, std::int64_t period_ns, Jitter& jitter,
                  const std::atomic<bool>& stop, Tick&& tick) {
  Schedule schedule(clock.now_ns() + period_ns, period_ns);
  while (!stop.load(std::memory_order_relaxed)) {
    clock.wait_until(schedule.deadline_ns());
    const std::int64_t now_ns = clock.now_ns();
    if (now_ns < schedule.deadline_ns()) {
      continue;
    }
    const Wake wake = schedule.wake(now_ns);
    jitter.note(wake.late_ns, wake.missed);
    if (!tick(wake.missed)) {
      return;
    }
  }
}

}  // namespace hal::linux_os
