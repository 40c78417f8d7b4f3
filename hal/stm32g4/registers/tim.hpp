#pragma once

#include <cstddef>

#include "hal/stm32g4/registers/word.hpp"

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

}  // namespace hal::stm32g4
