#pragma once

#include <cstdint>

#include "hal/result.hpp"
#include "hal/stm32g4/registers/flash.hpp"
#include "hal/stm32g4/registers/pwr.hpp"
#include "hal/stm32g4/registers/rcc.hpp"

namespace hal::stm32g4 {

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
