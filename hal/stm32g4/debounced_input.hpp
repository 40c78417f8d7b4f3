#pragma once

#include <cstdint>

#include "hal/stm32g4/pins.hpp"
#include "lifemodel/support/shared_word.hpp"

namespace hal::stm32g4 {

/// hal::DigitalIn on a line that bounces. The interrupt of the control loop samples it; it changes
/// after `kSamples` equal samples in a row, so a change is seen within that time of its last edge.
template <Word W, std::uint32_t kSamples>
class DebouncedInput {
 public:
  DebouncedInput(Pin<W> pin, Active active) : pin_(pin), active_(active) {}

  /// Takes the level as it is now.
  void start(Pull pull) {
    make_input(pin_, pull);
    asserted_.set_relaxed(level() ? 1 : 0);
    started_.set_relaxed(1);
  }

  void isr_sample() {
    const std::uint32_t now = level() ? 1 : 0;
    differing_ = now == asserted_.own() ? 0 : differing_ + 1;
    if (differing_ == kSamples) {
      asserted_.set_relaxed(now);
      differing_ = 0;
    }
  }

  /// off, before start().
  [[nodiscard]] Result<bool> asserted() const {
    if (started_.relaxed() == 0) {
      return Error::off;
    }
    return asserted_.relaxed() != 0;
  }

 private:
  [[nodiscard]] bool level() const {
    return ((pin_.port.idr.read() & bit(pin_.line)) != 0) == (active_ == Active::high);
  }

  Pin<W> pin_;
  Active active_;
  std::uint32_t differing_ = 0;
  lifemodel::SharedWord<std::uint32_t> asserted_;
  lifemodel::SharedWord<std::uint32_t> started_;
};

}  // namespace hal::stm32g4
