#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace hal::stm32g4 {

/// How punctual the interrupt of the control loop is, from the time between two of them.
class SampleTiming {
 public:
  /// Periods that the interrupt missed since the last call. Time that wraps is fine.
  std::uint32_t isr_period(std::uint32_t now_us, std::uint32_t period_us) {
    const std::uint32_t elapsed_us = now_us - last_us_;
    last_us_ = now_us;
    in_time_ = false;
    if (!started_) {
      started_ = true;
      return 0;
    }
    const std::uint32_t periods = (elapsed_us + period_us / 2) / period_us;
    const std::uint32_t due_us = periods * period_us;
    in_time_ = periods == 1;
    note(elapsed_us > due_us ? elapsed_us - due_us : due_us - elapsed_us);
    const std::uint32_t missed = periods > 1 ? periods - 1 : 0;
    missed_ += missed;
    return missed;
  }

  /// The last call came one period after the one before it, to half a period.
  [[nodiscard]] bool isr_in_time() const { return in_time_; }

  /// Periods missed so far.
  [[nodiscard]] std::uint32_t missed() const { return missed_; }

  [[nodiscard]] std::uint32_t worst_us() const { return worst_us_; }

  /// Jitter that 99 % of the periods so far do not exceed; stops at kClasses - 1.
  [[nodiscard]] std::uint32_t p99_us() const {
    const std::uint32_t allowed = total_ / 100;
    std::uint32_t above = 0;
    for (std::size_t i = kClasses; i > 1; --i) {
      above += counts_[i - 1];
      if (above > allowed) {
        return static_cast<std::uint32_t>(i - 1);
      }
    }
    return 0;
  }

 private:
  static constexpr std::size_t kClasses = 32;  ///< of one microsecond; the last is open above

  void note(std::uint32_t jitter_us) {
    worst_us_ = std::max(worst_us_, jitter_us);
    ++counts_[std::min<std::size_t>(jitter_us, kClasses - 1)];
    // Once full, the past weighs half.
    if (++total_ == 0x80000000u) {
      total_ = 0;
      for (std::uint32_t& count : counts_) {
        count /= 2;
        total_ += count;
      }
    }
  }

  bool started_ = false;
  bool in_time_ = false;
  std::uint32_t last_us_ = 0;
  std::uint32_t worst_us_ = 0;
  std::uint32_t missed_ = 0;
  std::uint32_t total_ = 0;
  std::array<std::uint32_t, kClasses> counts_{};
};

}  // namespace hal::stm32g4
