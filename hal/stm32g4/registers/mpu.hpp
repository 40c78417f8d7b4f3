#pragma once

#include <cstddef>

#include "hal/stm32g4/registers/word.hpp"

namespace hal::stm32g4 {

/// Memory protection unit, DDI 0403E B3.5.4.
template <Word W>
struct MpuRegisters {
  W type, ctrl, rnr, rbar, rasr;
};
static_assert(offsetof(MpuRegisters<Register>, rasr) == 0x10);

namespace mpu {
inline constexpr std::uint32_t kEnable = bit(0), kDefaultMapElsewhere = bit(2);
inline constexpr std::uint32_t kEnableRegion = bit(0), kNoAccess = 0u << 24;
inline constexpr std::uint32_t kNormalMemory = 1u << 17;
inline constexpr std::uint32_t kSize32 = 4u << 1;  ///< 2^(4 + 1) bytes
}  // namespace mpu

}  // namespace hal::stm32g4
