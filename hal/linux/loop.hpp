#pragma once

#include <time.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string>

#include "hal/linux/monotonic_clock.hpp"

namespace hal::linux_os {

/// What a wake-up found.
struct Wake {
  std::int64_t late_ns = 0;  ///< after the deadline, 0 where it was early
  std::uint32_t missed = 0;  ///< deadlines after this one that have passed too
};

/// Deadlines of a periodic task on an absolute clock. Deadlines that were missed are counted and
/// left out: the next one is always a whole number of periods after the first, and ahead.
class Schedule {
 public:
  /// @pre period_ns > 0
  Schedule(std::int64_t start_ns, std::int64_t period_ns)
      : deadline_ns_(start_ns), period_ns_(period_ns) {}

  /// When to wake up next.
  [[nodiscard]] std::int64_t deadline_ns() const { return deadline_ns_; }

  /// Takes in a wake-up and moves the deadline on.
  Wake wake(std::int64_t now_ns) {
    Wake wake;
    if (now_ns > deadline_ns_) {
      wake.late_ns = now_ns - deadline_ns_;
      const std::int64_t missed = wake.late_ns / period_ns_;
      wake.missed = missed < kMost ? static_cast<std::uint32_t>(missed) : kMost;
      deadline_ns_ += missed * period_ns_;
    }
    deadline_ns_ += period_ns_;
    return wake;
  }

 private:
  static constexpr std::uint32_t kMost = 0xffff'ffff;

  std::int64_t deadline_ns_;
  std::int64_t period_ns_;
};

/// How late a periodic task woke up, in classes of 1 us; the last class is open above. One thread
/// notes, any may read: each number is right for itself.
class Jitter {
 public:
  static constexpr std::size_t kClasses = 1'024;

  /// @pre late_ns >= 0
  void note(std::int64_t late_ns, std::uint32_t missed) {
    const auto late_us = static_cast<std::uint64_t>(late_ns) / 1'000;
    add(classes_[late_us < kClasses ? static_cast<std::size_t>(late_us) : kClasses - 1], 1);
    add(missed_, missed);
    if (late_us > worst_us_.load(std::memory_order_relaxed)) {
      worst_us_.store(late_us, std::memory_order_relaxed);
    }
  }

  [[nodiscard]] std::uint64_t worst_us() const { return worst_us_.load(std::memory_order_relaxed); }
  [[nodiscard]] std::uint64_t missed() const { return missed_.load(std::memory_order_relaxed); }
  [[nodiscard]] std::uint64_t count(std::size_t late_us) const {
    return classes_[late_us].load(std::memory_order_relaxed);
  }

  /// The lateness that `per_mille` of all wake-ups did not exceed, rounded up to 1 us; the worst
  /// where that lies in the open class, 0 without wake-ups. @pre per_mille <= 1000
  [[nodiscard]] std::uint64_t quantile_us(std::uint32_t per_mille) const {
    std::uint64_t all = 0;
    for (const auto& one : classes_) {
      all += one.load(std::memory_order_relaxed);
    }
    const std::uint64_t wanted =
        (all / 1'000) * per_mille + (all % 1'000 * per_mille + 999) / 1'000;
    std::uint64_t seen = 0;
    for (std::size_t i = 0; i + 1 < kClasses && all != 0; ++i) {
      seen += classes_[i].load(std::memory_order_relaxed);
      if (seen >= wanted) {
        return i + 1 < worst_us() ? i + 1 : worst_us();
      }
    }
    return worst_us();
  }

 private:
  static void add(std::atomic<std::uint64_t>& sum, std::uint64_t n) {
    sum.store(sum.load(std::memory_order_relaxed) + n, std::memory_order_relaxed);
  }

  std::array<std::atomic<std::uint64_t>, kClasses> classes_{};
  std::atomic<std::uint64_t> missed_{0};
  std::atomic<std::uint64_t> worst_us_{0};
};

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

/// Locks all memory, now and later, so that no page fault delays a loop (mlockall(2)). Gives an
/// empty text, or what went wrong and what would help.
std::string lock_memory();

/// Puts the calling thread under SCHED_FIFO (sched(7)). Gives an empty text, or what went wrong and
/// what would help. @pre 1 <= priority <= 99
std::string schedule_fifo(int priority);

/// Puts the calling thread under SCHED_OTHER; threads that it started keep theirs.
void schedule_normally();

}  // namespace hal::linux_os
