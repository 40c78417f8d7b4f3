#pragma once

#include <cstddef>

#include "hal/stm32g4/registers/word.hpp"

namespace hal::stm32g4 {

/// Operational amplifiers of category 2 devices, RM0440 25.5. The file has places for six.
template <Word W>
struct OpampRegisters {
  W csr[6];
  W tcmr[6];
};
static_assert(offsetof(OpampRegisters<Register>, tcmr) == 0x18);

namespace opamp {
// CSR, 25.5.1
inline constexpr std::uint32_t kEnable = bit(0), kInput0 = 0u << 2;
inline constexpr std::uint32_t kProgrammableGain = 2u << 5, kHighSpeed = bit(7);
inline constexpr std::uint32_t kInternalOutput = bit(8);
/// Gain 16, with the low side of the shunt's divider on VINM0.
inline constexpr std::uint32_t kGain16BiasOnInput0 = 0x0Bu << 14;
}  // namespace opamp

}  // namespace hal::stm32g4
