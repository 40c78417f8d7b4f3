#pragma once

#include <cstddef>

#include "hal/stm32g4/registers/word.hpp"

namespace hal::stm32g4 {

/// Reset and clock control, RM0440 7.4.
template <Word W>
struct RccRegisters {
  W cr, icscr, cfgr, pllcfgr;
  W reserved_10[2];
  W cier, cifr, cicr;
  W reserved_24;
  W ahb1rstr, ahb2rstr, ahb3rstr;
  W reserved_34;
  W apb1rstr1, apb1rstr2, apb2rstr;
  W reserved_44;
  W ahb1enr, ahb2enr, ahb3enr;
  W reserved_54;
  W apb1enr1, apb1enr2, apb2enr;
  W reserved_64;
  W ahb1smenr, ahb2smenr, ahb3smenr;
  W reserved_74;
  W apb1smenr1, apb1smenr2, apb2smenr;
  W reserved_84;
  W ccipr;
  W reserved_8c;
  W bdcr, csr, crrcr, ccipr2;
};
static_assert(offsetof(RccRegisters<Register>, pllcfgr) == 0x0C);
static_assert(offsetof(RccRegisters<Register>, cicr) == 0x20);
static_assert(offsetof(RccRegisters<Register>, ahb1enr) == 0x48);
static_assert(offsetof(RccRegisters<Register>, ahb2enr) == 0x4C);
static_assert(offsetof(RccRegisters<Register>, apb1enr1) == 0x58);
static_assert(offsetof(RccRegisters<Register>, apb2enr) == 0x60);
static_assert(offsetof(RccRegisters<Register>, ccipr) == 0x88);
static_assert(offsetof(RccRegisters<Register>, csr) == 0x94);
static_assert(offsetof(RccRegisters<Register>, crrcr) == 0x98);
static_assert(sizeof(RccRegisters<Register>) == 0xA0);

namespace rcc {
// CR, 7.4.1
inline constexpr std::uint32_t kHsi16On = bit(8), kHsi16Ready = bit(10);
inline constexpr std::uint32_t kHseOn = bit(16), kHseReady = bit(17), kCssOn = bit(19);
inline constexpr std::uint32_t kPllOn = bit(24), kPllReady = bit(25);
// CFGR, 7.4.3
inline constexpr std::uint32_t kSwitchMask = 3u << 0, kSwitchPll = 3u << 0, kSwitchHsi16 = 1u << 0;
inline constexpr std::uint32_t kSwitchStatusMask = 3u << 2, kSwitchStatusPll = 3u << 2;
inline constexpr std::uint32_t kSwitchStatusHsi16 = 1u << 2;
inline constexpr std::uint32_t kHclkMask = 15u << 4, kHclkBy2 = 8u << 4;
// PLLCFGR, 7.4.4
inline constexpr std::uint32_t kPllSourceHsi16 = 2, kPllSourceHse = 3;
constexpr std::uint32_t pll_m(std::uint32_t divisor) {
  return (divisor - 1) << 4;
}
constexpr std::uint32_t pll_n(std::uint32_t factor) {
  return factor << 8;
}
inline constexpr std::uint32_t kPllREnable = bit(24), kPllRBy2 = 0;
// CIFR, 7.4.6
inline constexpr std::uint32_t kCssFlag = bit(8);
// AHB2ENR, 7.4.14
inline constexpr std::uint32_t kGpioA = bit(0), kGpioB = bit(1), kGpioC = bit(2);
inline constexpr std::uint32_t kAdc12 = bit(13), kRng = bit(26);
// APB1ENR1, 7.4.16
inline constexpr std::uint32_t kTim2 = bit(0), kFdcan = bit(25), kPwr = bit(28);
// APB2ENR, 7.4.18
inline constexpr std::uint32_t kSyscfg = bit(0), kTim1 = bit(11);
// CCIPR, 7.4.26
inline constexpr std::uint32_t kFdcanMask = 3u << 24, kFdcanPclk1 = 2u << 24;
inline constexpr std::uint32_t kClk48Mask = 3u << 26, kClk48Hsi48 = 0u << 26;
// CSR, 7.4.28
inline constexpr std::uint32_t kRemoveResetFlags = bit(23), kWatchdogReset = bit(29);
// CRRCR, 7.4.29
inline constexpr std::uint32_t kHsi48On = bit(0), kHsi48Ready = bit(1);
}  // namespace rcc

}  // namespace hal::stm32g4
