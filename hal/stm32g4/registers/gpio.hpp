#pragma once

#include <cstddef>

#include "hal/stm32g4/registers/word.hpp"

namespace hal::stm32g4 {

/// One port of general-purpose lines, RM0440 9.4.
template <Word W>
struct GpioRegisters {
  W moder, otyper, ospeedr, pupdr, idr, odr, bsrr, lckr;
  W afr[2];  ///< AFRL, AFRH
  W brr;
};
static_assert(offsetof(GpioRegisters<Register>, idr) == 0x10);
static_assert(offsetof(GpioRegisters<Register>, bsrr) == 0x18);
static_assert(offsetof(GpioRegisters<Register>, afr) == 0x20);
static_assert(offsetof(GpioRegisters<Register>, brr) == 0x28);

}  // namespace hal::stm32g4
