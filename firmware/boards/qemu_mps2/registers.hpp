#pragma once

#include <cstdint>

#include "hal/qemu_mps2/uart.hpp"

/// Core registers, ARMv7-M Architecture Reference Manual (DDI 0403E), B3.2.2, B3.3.2, B3.4.3
/// and B3.5.4.
namespace boards::qemu_mps2::registers {

class Register {
 public:
  constexpr explicit Register(std::uintptr_t address) : address_(address) {}
  [[nodiscard]] std::uint32_t read() const { return *pointer(); }
  void write(std::uint32_t value) const { *pointer() = value; }

 private:
  [[nodiscard]] volatile std::uint32_t* pointer() const {
    return reinterpret_cast<volatile std::uint32_t*>(address_);
  }
  std::uintptr_t address_;
};

inline constexpr Register kSysTickControl{0xE000E010};
inline constexpr Register kSysTickReload{0xE000E014};
inline constexpr Register kSysTickCurrent{0xE000E018};
inline constexpr Register kInterruptControlState{0xE000ED04};
inline constexpr Register kSystemHandlerPriority3{0xE000ED20};
inline constexpr Register kInterruptSetEnable0{0xE000E100};
inline constexpr Register kInterruptPriority0{0xE000E400};
inline constexpr Register kConfigurableFaultStatus{0xE000ED28};
inline constexpr Register kMpuControl{0xE000ED94};
inline constexpr Register kMpuRegionNumber{0xE000ED98};
inline constexpr Register kMpuRegionBase{0xE000ED9C};
inline constexpr Register kMpuRegionAttributes{0xE000EDA0};

}  // namespace boards::qemu_mps2::registers

/// UART 0 of the AN386 image, which QEMU hands to the host by -serial.
namespace boards::qemu_mps2 {

inline constexpr std::uint32_t kClock_Hz = 25'000'000;
inline constexpr std::uint32_t kUart0_bits_per_s = 1'000'000;

using Uart0 = hal::qemu_mps2::Uart<>;

inline hal::qemu_mps2::UartRegisters& uart0_registers() {
  constexpr std::uintptr_t kBase = 0x4000'4000;
  return *reinterpret_cast<hal::qemu_mps2::UartRegisters*>(kBase);
}

}  // namespace boards::qemu_mps2
