#pragma once

#include <cstddef>

#include "hal/stm32g4/registers/word.hpp"

namespace hal::stm32g4 {

/// Power control, RM0440 6.4.
template <Word W>
struct PwrRegisters {
  W cr1, cr2, cr3, cr4, sr1, sr2, scr;
  W reserved_1c;
  W pull[14];  ///< PUCRA, PDCRA .. PUCRG, PDCRG
  W reserved_58[10];
  W cr5;
};
static_assert(offsetof(PwrRegisters<Register>, cr3) == 0x08);
static_assert(offsetof(PwrRegisters<Register>, sr2) == 0x14);
static_assert(offsetof(PwrRegisters<Register>, pull) == 0x20);
static_assert(offsetof(PwrRegisters<Register>, cr5) == 0x80);

namespace pwr {
// CR1, 6.4.1
inline constexpr std::uint32_t kVoltageMask = 3u << 9, kVoltageRange1 = 1u << 9;
// CR3, 6.4.3
inline constexpr std::uint32_t kNoDeadBattery = bit(14);
// SR2, 6.4.6
inline constexpr std::uint32_t kVoltageChanging = bit(10);
// CR5, 6.4.22
inline constexpr std::uint32_t kRange1NotBoosted = bit(8);
}  // namespace pwr

}  // namespace hal::stm32g4
