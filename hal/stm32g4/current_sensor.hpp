#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "hal/stm32g4/phase_current.hpp"
#include "hal/stm32g4/shunt_converters.hpp"

namespace hal::stm32g4 {

/// hal::CurrentSensor of the one motor of the board.
template <Word W>
class CurrentSensor {
 public:
  using Sample = lifemodel::MotorCurrent;

  explicit CurrentSensor(ShuntConverters<W>& converters) : converters_(converters) {}

  /// Measures the zeros while the drive is off and nothing moves, before the interrupt is enabled.
  /// failed, where the trigger does not come or an amplifier is broken; every sample then fails.
  Error calibrate_at_rest() {
    for (std::uint32_t i = 0; i < PhaseCurrent::kRestSamples; ++i) {
      std::uint32_t polls = 0;
      while (!converters_.isr_ready()) {
        if (++polls == kPolls) {
          return Error::failed;
        }
      }
      current_.take_rest(converters_.isr_take());
    }
    return current_.finish_rest();
  }

  /// First in the interrupt: takes what the converters have, which ends their request.
  void isr_latch() {
    if (converters_.isr_ready()) {
      latched_ = converters_.isr_take();
    }
  }

  /// One tendon: out_of_range for others. missing, where nothing was latched since.
  [[nodiscard]] Result<Sample> isr_read(std::size_t tendon) {
    if (tendon != 0) {
      return Error::out_of_range;
    }
    if (!latched_) {
      return Error::missing;
    }
    const PhaseCounts counts = *latched_;
    latched_.reset();
    return current_.isr_amplitude(counts);
  }

 private:
  static constexpr std::uint32_t kPolls = 1'000'000;
  ShuntConverters<W>& converters_;
  PhaseCurrent current_;
  std::optional<PhaseCounts> latched_;
};

}  // namespace hal::stm32g4
