#pragma once

#include <cstdint>

#include "hal/qemu_mps2/uart.hpp"

/// UART 0 of the AN386 image, which QEMU hands to the host by -serial.
namespace firmware::qemu_mps2 {

inline constexpr std::uint32_t kClock_Hz = 25'000'000;
inline constexpr std::uint32_t kUart0_bits_per_s = 1'000'000;

using Uart0 = hal::qemu_mps2::Uart<>;

inline hal::qemu_mps2::UartRegisters& uart0_registers() {
  constexpr std::uintptr_t kBase = 0x4000'4000;
  return *reinterpret_cast<hal::qemu_mps2::UartRegisters*>(kBase);
}

}  // namespace firmware::qemu_mps2
