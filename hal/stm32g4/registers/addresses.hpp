#pragma once

#include <cstdint>

/// Where the register files lie: RM0440 2.2.2, memory map of category 2 devices.
namespace hal::stm32g4::addresses {

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

}  // namespace hal::stm32g4::addresses
