#pragma once

#include <cstdint>

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
  /// Precondition: period_ns > 0.
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

}  // namespace hal::linux_os
