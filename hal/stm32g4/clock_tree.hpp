#pragma once

#include <cstddef>
#include <cstdint>

#include "hal/error.hpp"
#include "hal/stm32g4/flash_memory.hpp"
#include "hal/stm32g4/register.hpp"

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

/// What the clocks are derived from.
enum class Oscillator : std::uint8_t {
  crystal_8MHz,   ///< HSE, watched by the clock security system
  internal_16MHz  ///< HSI16, 1 % off: CAN at 1 Mbit/s is then out of its tolerance over temperature
};

/// Clock of the core, of both peripheral busses and of the timers.
inline constexpr std::uint32_t kCore_Hz = 170'000'000;

/// Brings core and busses from 16 MHz after reset to 170 MHz: voltage range 1 boosted, 4 wait
/// states, PLL 340 MHz / 2. Takes the crystal if it starts, else the internal oscillator.
template <Word W>
class ClockTree {
 public:
  ClockTree(RccRegisters<W>& rcc, PwrRegisters<W>& pwr, FlashRegisters<W>& flash)
      : rcc_(rcc), pwr_(pwr), flash_(flash) {}

  /// failed, where the device does not get ready; it then still runs at 16 MHz or half speed.
  Result<Oscillator> start() {
    if (fall_back() != Error::none || boost() != Error::none) {
      return Error::failed;
    }
    set_bits(rcc_.cr, rcc::kHseOn);
    const bool crystal =
        wait_until(rcc_.cr, rcc::kHseReady, rcc::kHseReady, kCrystalPolls) == Error::none;
    if (!crystal) {
      clear_bits(rcc_.cr, rcc::kHseOn);
    }
    if (start_pll(crystal) != Error::none || wait_states() != Error::none ||
        switch_over() != Error::none) {
      return Error::failed;
    }
    if (crystal) {
      set_bits(rcc_.cr, rcc::kCssOn);
    }
    return crystal ? Oscillator::crystal_8MHz : Oscillator::internal_16MHz;
  }

 private:
  static constexpr std::uint32_t kReadyPolls = 100'000;
  static constexpr std::uint32_t kCrystalPolls = 200'000;  ///< more than 25 ms at 16 MHz
  /// Reads that take more than the 1 us of RM0440 6.1.5 at 85 MHz, where one takes two cycles.
  static constexpr std::uint32_t kHalfSpeedPolls = 200;

  /// To the internal oscillator, for the boot loader of the device may have left the PLL in use.
  Error fall_back() {
    set_bits(rcc_.cr, rcc::kHsi16On);
    if (wait_until(rcc_.cr, rcc::kHsi16Ready, rcc::kHsi16Ready, kReadyPolls) != Error::none) {
      return Error::failed;
    }
    replace_bits(rcc_.cfgr, rcc::kSwitchMask, rcc::kSwitchHsi16);
    if (wait_until(rcc_.cfgr, rcc::kSwitchStatusMask, rcc::kSwitchStatusHsi16, kReadyPolls) !=
        Error::none) {
      return Error::failed;
    }
    clear_bits(rcc_.cr, rcc::kPllOn);
    return wait_until(rcc_.cr, rcc::kPllReady, 0, kReadyPolls);
  }

  /// RM0440 6.1.5.
  Error boost() {
    set_bits(rcc_.apb1enr1, rcc::kPwr);
    // RM0440 7.2.17: a peripheral answers two cycles after its clock was turned on.
    if (wait_until(rcc_.apb1enr1, rcc::kPwr, rcc::kPwr, kReadyPolls) != Error::none) {
      return Error::failed;
    }
    replace_bits(pwr_.cr1, pwr::kVoltageMask, pwr::kVoltageRange1);
    clear_bits(pwr_.cr5, pwr::kRange1NotBoosted);
    // Pins of the dead-battery pull-downs are used otherwise, RM0440 6.4.3.
    set_bits(pwr_.cr3, pwr::kNoDeadBattery);
    return wait_until(pwr_.sr2, pwr::kVoltageChanging, 0, kReadyPolls);
  }

  /// RM0440 7.2.4: configured while it is off; 4 MHz x 85 / 2.
  Error start_pll(bool crystal) {
    const std::uint32_t source =
        crystal ? rcc::kPllSourceHse | rcc::pll_m(2) : rcc::kPllSourceHsi16 | rcc::pll_m(4);
    rcc_.pllcfgr.write(source | rcc::pll_n(85) | rcc::kPllRBy2 | rcc::kPllREnable);
    set_bits(rcc_.cr, rcc::kPllOn);
    return wait_until(rcc_.cr, rcc::kPllReady, rcc::kPllReady, kReadyPolls);
  }

  /// RM0440 5.3.3: before the clock rises, and read back.
  Error wait_states() {
    replace_bits(flash_.acr, flash::kLatencyMask, flash::kLatency4);
    if (wait_until(flash_.acr, flash::kLatencyMask, flash::kLatency4, kReadyPolls) != Error::none) {
      return Error::failed;
    }
    set_bits(flash_.acr, flash::kPrefetch | flash::kInstructionCache | flash::kDataCache);
    return Error::none;
  }

  /// RM0440 6.1.5: at half speed for 1 us on the way.
  Error switch_over() {
    replace_bits(rcc_.cfgr, rcc::kHclkMask, rcc::kHclkBy2);
    replace_bits(rcc_.cfgr, rcc::kSwitchMask, rcc::kSwitchPll);
    if (wait_until(rcc_.cfgr, rcc::kSwitchStatusMask, rcc::kSwitchStatusPll, kReadyPolls) !=
        Error::none) {
      return Error::failed;
    }
    for (std::uint32_t i = 0; i < kHalfSpeedPolls; ++i) {
      static_cast<void>(rcc_.cfgr.read());
    }
    clear_bits(rcc_.cfgr, rcc::kHclkMask);
    return Error::none;
  }

  RccRegisters<W>& rcc_;
  PwrRegisters<W>& pwr_;
  FlashRegisters<W>& flash_;
};

/// Clocks of the peripherals that the back ends need: FDCAN from the bus, RNG from HSI48.
template <Word W>
Error enable_peripherals(RccRegisters<W>& rcc) {
  constexpr std::uint32_t kPolls = 100'000;
  set_bits(rcc.crrcr, rcc::kHsi48On);
  if (wait_until(rcc.crrcr, rcc::kHsi48Ready, rcc::kHsi48Ready, kPolls) != Error::none) {
    return Error::failed;
  }
  replace_bits(rcc.ccipr, rcc::kFdcanMask | rcc::kClk48Mask, rcc::kFdcanPclk1 | rcc::kClk48Hsi48);
  constexpr std::uint32_t kAhb2 = rcc::kGpioA | rcc::kGpioB | rcc::kGpioC | rcc::kAdc12 | rcc::kRng;
  constexpr std::uint32_t kApb1 = rcc::kTim2 | rcc::kFdcan;
  constexpr std::uint32_t kApb2 = rcc::kSyscfg | rcc::kTim1;
  set_bits(rcc.ahb2enr, kAhb2);
  set_bits(rcc.apb1enr1, kApb1);
  set_bits(rcc.apb2enr, kApb2);
  return wait_until(rcc.apb2enr, kApb2, kApb2, kPolls);
}

}  // namespace hal::stm32g4
