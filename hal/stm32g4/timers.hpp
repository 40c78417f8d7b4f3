#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "hal/clock.hpp"
#include "hal/stm32g4/register.hpp"
#include "lifemodel/support/shared_word.hpp"

namespace hal::stm32g4 {

/// A timer: advanced-control TIM1, RM0440 28.6; TIM2 has the same places, RM0440 29.5.
template <Word W>
struct TimRegisters {
  W cr1, cr2, smcr, dier, sr, egr, ccmr1, ccmr2, ccer, cnt, psc, arr, rcr;
  W ccr[4];
  W bdtr;
};
static_assert(offsetof(TimRegisters<Register>, egr) == 0x14);
static_assert(offsetof(TimRegisters<Register>, ccmr2) == 0x1C);
static_assert(offsetof(TimRegisters<Register>, cnt) == 0x24);
static_assert(offsetof(TimRegisters<Register>, arr) == 0x2C);
static_assert(offsetof(TimRegisters<Register>, ccr) == 0x34);
static_assert(offsetof(TimRegisters<Register>, bdtr) == 0x44);

namespace tim {
// CR1, 28.6.1
inline constexpr std::uint32_t kEnable = bit(0), kCentreAligned1 = 1u << 5;
// CR2, 28.6.2: TRGO2 is OC4REF
inline constexpr std::uint32_t kTrgo2Oc4Ref = 7u << 20;
// EGR, 28.6.6
inline constexpr std::uint32_t kUpdate = bit(0);
// CCMR2, 28.6.9
inline constexpr std::uint32_t kOc4PwmMode2 = 7u << 12;
}  // namespace tim

/// hal::Clock on TIM2, which counts microseconds in 32 bits (RM0440 29.4). The interrupt of the
/// control loop counts its turns of 71 minutes.
template <Word W>
class MicrosecondClock {
 public:
  explicit MicrosecondClock(TimRegisters<W>& timer) : timer_(timer) {}

  /// `input_Hz` is a multiple of 1 MHz.
  void start(std::uint32_t input_Hz) {
    timer_.cr1.write(0);
    timer_.psc.write(input_Hz / 1'000'000 - 1);
    timer_.arr.write(0xFFFFFFFFu);
    // Takes the prescaler over at once and starts from 0 (RM0440 29.4.1).
    timer_.egr.write(tim::kUpdate);
    timer_.cr1.write(tim::kEnable);
  }

  /// Must be called at least every 71 minutes; gives the count.
  std::uint32_t isr_tick() {
    const std::uint32_t count = timer_.cnt.read();
    if (count < seen_.own()) {
      turns_.set_relaxed(turns_.own() + 1);
    }
    seen_.set_relaxed(count);
    return count;
  }

  [[nodiscard]] Time now() const {
    std::uint32_t turns = 0;
    std::uint32_t seen = 0;
    std::uint32_t count = 0;
    do {
      turns = turns_.relaxed();
      seen = seen_.relaxed();
      count = timer_.cnt.read();
    } while (turns != turns_.relaxed());
    // A turn that the interrupt has not seen yet.
    turns += count < seen ? 1 : 0;
    return {std::uint64_t{turns} << 32 | count};
  }

  /// Waits; for bring-up.
  void wait_us(std::uint32_t us) const {
    const std::uint32_t began = timer_.cnt.read();
    while (timer_.cnt.read() - began <= us) {
    }
  }

 private:
  TimRegisters<W>& timer_;
  lifemodel::SharedWord<std::uint32_t> turns_;
  lifemodel::SharedWord<std::uint32_t> seen_;
};

/// TIM1 counts up and down with the period of the control loop and triggers the converters by
/// TRGO2 at its top, in the middle of the time for which the low sides would conduct (RM0440
/// 28.3.3, 28.3.27). Its outputs stay off.
template <Word W>
class SampleTimer {
 public:
  explicit SampleTimer(TimRegisters<W>& timer) : timer_(timer) {}

  /// `input_Hz` / (2 * `rate_Hz`) fits 16 bits.
  void start(std::uint32_t input_Hz, std::uint32_t rate_Hz) {
    const std::uint32_t top = input_Hz / (2 * rate_Hz);
    timer_.cr1.write(tim::kCentreAligned1);
    timer_.cr2.write(tim::kTrgo2Oc4Ref);
    // PWM mode 2: active from the compare value up to the top and down again.
    timer_.ccmr2.write(tim::kOc4PwmMode2);
    timer_.psc.write(0);
    timer_.arr.write(top);
    timer_.ccr[3].write(top - 1);
    timer_.egr.write(tim::kUpdate);
    timer_.cr1.write(tim::kCentreAligned1 | tim::kEnable);
  }

 private:
  TimRegisters<W>& timer_;
};

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
