#pragma once

#include <cstddef>

#include "hal/stm32g4/register.hpp"

namespace hal::stm32g4 {

/// System control block, ARMv7-M Architecture Reference Manual (DDI 0403E) B3.2.2.
template <Word W>
struct SystemControlRegisters {
  W cpuid, icsr, vtor, aircr, scr, ccr;
  W shpr[3];
  W shcsr, cfsr, hfsr;
};
static_assert(offsetof(SystemControlRegisters<Register>, vtor) == 0x08);
static_assert(offsetof(SystemControlRegisters<Register>, aircr) == 0x0C);
static_assert(offsetof(SystemControlRegisters<Register>, shpr) == 0x18);
static_assert(offsetof(SystemControlRegisters<Register>, cfsr) == 0x28);

/// Interrupt controller, DDI 0403E B3.4.3.
template <Word W>
struct InterruptRegisters {
  W iser[8];
  W reserved_120[24];
  W icer[8];
  W reserved_1a0[24];
  W ispr[8];
  W reserved_220[24];
  W icpr[8];
  W reserved_2a0[24];
  W iabr[8];
  W reserved_320[56];
  W ipr[60];
};
static_assert(offsetof(InterruptRegisters<Register>, icer) == 0x080);
static_assert(offsetof(InterruptRegisters<Register>, ipr) == 0x300);

namespace core {
inline constexpr std::uint32_t kPendSvSet = bit(28);
/// AIRCR takes writes only with this key in its high half.
inline constexpr std::uint32_t kSystemReset = 0x05FA0000u | bit(2);
/// The device has 4 bits of priority, the highest of a byte; a smaller number goes first.
constexpr std::uint32_t priority(std::uint32_t level) {
  return level << 4;
}
inline constexpr unsigned kPendSvShift = 16;  ///< in SHPR3
}  // namespace core

/// Position in the vector table less 16, RM0440 14.3.
inline constexpr unsigned kAdc12Interrupt = 18;
inline constexpr unsigned kInterrupts = 102;

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
