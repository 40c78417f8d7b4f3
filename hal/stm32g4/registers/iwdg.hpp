#pragma once

#include <cstddef>

#include "hal/stm32g4/registers/word.hpp"

namespace hal::stm32g4 {

/// Independent watchdog, RM0440 42.4.
template <Word W>
struct IwdgRegisters {
  W kr, pr, rlr, sr, winr;
};
static_assert(offsetof(IwdgRegisters<Register>, sr) == 0x0C);

namespace iwdg {
// KR, 42.4.1
inline constexpr std::uint32_t kStart = 0xCCCC, kUnlock = 0x5555, kReload = 0xAAAA;
// PR, 42.4.2
inline constexpr std::uint32_t kDivideBy32 = 3;
}  // namespace iwdg

}  // namespace hal::stm32g4
