#pragma once

#include <cstdint>

#include "hal/clock.hpp"
#include "hal/stm32g4/registers/tim.hpp"
#include "lifemodel/support/shared_word.hpp"

namespace hal::stm32g4 {

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

}  // namespace hal::stm32g4
