#pragma once

#include <cstdint>

#include "hal/error.hpp"
#include "hal/stm32g4/registers/iwdg.hpp"

namespace hal::stm32g4 {

/// hal::Watchdog: the independent watchdog, which nothing but a reset stops (RM0440 42.3).
template <Word W>
class IndependentWatchdog {
 public:
  explicit IndependentWatchdog(IwdgRegisters<W>& registers) : registers_(registers) {}

  /// `period_ms` 1 .. 4096; LSI is up to 8 % off. RM0440 42.3.2.
  Error start(std::uint32_t period_ms) {
    if (period_ms < 1 || period_ms > 4096) {
      return Error::out_of_range;
    }
    registers_.kr.write(iwdg::kStart);
    registers_.kr.write(iwdg::kUnlock);
    registers_.pr.write(iwdg::kDivideBy32);
    registers_.rlr.write(period_ms - 1);
    const Error taken_over = wait_until(registers_.sr, 7, 0, kPolls);
    feed();
    return taken_over;
  }

  void feed() { registers_.kr.write(iwdg::kReload); }

 private:
  static constexpr std::uint32_t kPolls = 1'000'000;
  IwdgRegisters<W>& registers_;
};

}  // namespace hal::stm32g4
