#pragma once

#include "hal/stm32g4/registers/adc.hpp"
#include "hal/stm32g4/registers/addresses.hpp"
#include "hal/stm32g4/registers/core.hpp"
#include "hal/stm32g4/registers/fdcan.hpp"
#include "hal/stm32g4/registers/flash.hpp"
#include "hal/stm32g4/registers/gpio.hpp"
#include "hal/stm32g4/registers/iwdg.hpp"
#include "hal/stm32g4/registers/message_ram.hpp"
#include "hal/stm32g4/registers/mpu.hpp"
#include "hal/stm32g4/registers/opamp.hpp"
#include "hal/stm32g4/registers/pwr.hpp"
#include "hal/stm32g4/registers/rcc.hpp"
#include "hal/stm32g4/registers/rng.hpp"
#include "hal/stm32g4/registers/tim.hpp"

/// The register files of the device, at their addresses.
namespace board::registers {

using hal::stm32g4::Register;
namespace addresses = hal::stm32g4::addresses;

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

}  // namespace board::registers
