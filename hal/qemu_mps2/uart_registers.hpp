#pragma once

#include <cstddef>
#include <cstdint>

#include "hal/qemu_mps2/register.hpp"

/// The APB UART of the Cortex-M System Design Kit, Technical Reference Manual (DDI 0479), 4.3.
namespace hal::qemu_mps2 {

struct UartRegisters {
  Register data;
  Register state;
  Register control;
  Register interrupt;  ///< reads which are pending; writing ones clears those
  Register baud_divider;
};
static_assert(offsetof(UartRegisters, data) == 0x00);
static_assert(offsetof(UartRegisters, state) == 0x04);
static_assert(offsetof(UartRegisters, control) == 0x08);
static_assert(offsetof(UartRegisters, interrupt) == 0x0c);
static_assert(offsetof(UartRegisters, baud_divider) == 0x10);

namespace uart {

/// STATE. Overruns are cleared by writing ones.
inline constexpr std::uint32_t kTransmitFull = 1u << 0;
inline constexpr std::uint32_t kReceiveFull = 1u << 1;
inline constexpr std::uint32_t kTransmitOverrun = 1u << 2;
inline constexpr std::uint32_t kReceiveOverrun = 1u << 3;

/// CTRL.
inline constexpr std::uint32_t kTransmitEnable = 1u << 0;
inline constexpr std::uint32_t kReceiveEnable = 1u << 1;
inline constexpr std::uint32_t kReceiveInterruptEnable = 1u << 3;

/// INTSTATUS and INTCLEAR.
inline constexpr std::uint32_t kReceiveInterrupt = 1u << 1;

/// BAUDDIV: the clock is divided by 16 at least.
inline constexpr std::uint32_t kLowestDivider = 16;
inline constexpr std::uint32_t kHighestDivider = 0xf'ffff;

}  // namespace uart
}  // namespace hal::qemu_mps2
