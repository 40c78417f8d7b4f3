#pragma once

#include <cstddef>

#include "hal/stm32g4/registers/word.hpp"

namespace hal::stm32g4 {

/// Random number generator, RM0440 26.7.
template <Word W>
struct RngRegisters {
  W cr, sr, dr;
};
static_assert(offsetof(RngRegisters<Register>, dr) == 0x08);

namespace rng {
// CR, 26.7.1
inline constexpr std::uint32_t kEnable = bit(2);
// SR, 26.7.2
inline constexpr std::uint32_t kReady = bit(0), kClockNow = bit(1), kSeedNow = bit(2);
inline constexpr std::uint32_t kClockError = bit(5), kSeedError = bit(6);
}  // namespace rng

}  // namespace hal::stm32g4
