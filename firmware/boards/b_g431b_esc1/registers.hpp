#pragma once

#include <cstdint>

#include "hal/stm32g4/can_controller.hpp"
#include "hal/stm32g4/clock_tree.hpp"
#include "hal/stm32g4/core.hpp"
#include "hal/stm32g4/current_sensor.hpp"
#include "hal/stm32g4/flash_memory.hpp"
#include "hal/stm32g4/pins.hpp"
#include "hal/stm32g4/random.hpp"
#include "hal/stm32g4/timers.hpp"
#include "hal/stm32g4/watchdog.hpp"

/// Where the register files lie: RM0440 2.2.2, memory map of category 2 devices.
namespace boards::b_g431b_esc1::registers::addresses {

inline constexpr std::uintptr_t kTim2 = 0x40000000;
inline constexpr std::uintptr_t kIwdg = 0x40003000;
inline constexpr std::uintptr_t kFdcan1 = 0x40006400;
inline constexpr std::uintptr_t kPwr = 0x40007000;
inline constexpr std::uintptr_t kFdcan1MessageRam = 0x4000A400;
inline constexpr std::uintptr_t kOpamp = 0x40010300;
inline constexpr std::uintptr_t kTim1 = 0x40012C00;
inline constexpr std::uintptr_t kRcc = 0x40021000;
inline constexpr std::uintptr_t kFlash = 0x40022000;
inline constexpr std::uintptr_t kGpioA = 0x48000000;
inline constexpr std::uintptr_t kGpioB = 0x48000400;
inline constexpr std::uintptr_t kGpioC = 0x48000800;
inline constexpr std::uintptr_t kAdc1 = 0x50000000;
inline constexpr std::uintptr_t kAdc2 = 0x50000100;
inline constexpr std::uintptr_t kAdc12Common = 0x50000300;
inline constexpr std::uintptr_t kRng = 0x50060800;
inline constexpr std::uintptr_t kSystemControl = 0xE000ED00;
inline constexpr std::uintptr_t kMpu = 0xE000ED90;
inline constexpr std::uintptr_t kInterruptController = 0xE000E100;

inline constexpr std::uintptr_t kFlashArray = 0x08000000;

}  // namespace boards::b_g431b_esc1::registers::addresses

/// The register files of the device, at their addresses.
namespace boards::b_g431b_esc1::registers {

using hal::stm32g4::Register;

template <template <class> class File>
inline File<Register>& at(std::uintptr_t address) {
  return *reinterpret_cast<File<Register>*>(address);
}

inline auto& rcc() {
  return at<hal::stm32g4::RccRegisters>(addresses::kRcc);
}
inline auto& pwr() {
  return at<hal::stm32g4::PwrRegisters>(addresses::kPwr);
}
inline auto& flash() {
  return at<hal::stm32g4::FlashRegisters>(addresses::kFlash);
}
inline auto& gpio_a() {
  return at<hal::stm32g4::GpioRegisters>(addresses::kGpioA);
}
inline auto& gpio_b() {
  return at<hal::stm32g4::GpioRegisters>(addresses::kGpioB);
}
inline auto& gpio_c() {
  return at<hal::stm32g4::GpioRegisters>(addresses::kGpioC);
}
inline auto& adc1() {
  return at<hal::stm32g4::AdcRegisters>(addresses::kAdc1);
}
inline auto& adc2() {
  return at<hal::stm32g4::AdcRegisters>(addresses::kAdc2);
}
inline auto& adc12_common() {
  return at<hal::stm32g4::AdcCommonRegisters>(addresses::kAdc12Common);
}
inline auto& opamp() {
  return at<hal::stm32g4::OpampRegisters>(addresses::kOpamp);
}
inline auto& tim1() {
  return at<hal::stm32g4::TimRegisters>(addresses::kTim1);
}
inline auto& tim2() {
  return at<hal::stm32g4::TimRegisters>(addresses::kTim2);
}
inline auto& fdcan1() {
  return at<hal::stm32g4::FdcanRegisters>(addresses::kFdcan1);
}
inline auto& message_ram() {
  return at<hal::stm32g4::MessageRam>(addresses::kFdcan1MessageRam);
}
inline auto& iwdg() {
  return at<hal::stm32g4::IwdgRegisters>(addresses::kIwdg);
}
inline auto& rng() {
  return at<hal::stm32g4::RngRegisters>(addresses::kRng);
}
inline auto& system_control() {
  return at<hal::stm32g4::SystemControlRegisters>(addresses::kSystemControl);
}
inline auto& mpu() {
  return at<hal::stm32g4::MpuRegisters>(addresses::kMpu);
}
inline auto& interrupts() {
  return at<hal::stm32g4::InterruptRegisters>(addresses::kInterruptController);
}

}  // namespace boards::b_g431b_esc1::registers
