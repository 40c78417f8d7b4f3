#pragma once

#include <cstdint>

#include "hal/stm32g4/registers/tim.hpp"

namespace hal::stm32g4 {

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

}  // namespace hal::stm32g4
