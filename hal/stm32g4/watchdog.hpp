#pragma once

#include <cstddef>
#include <cstdint>

#include "hal/error.hpp"
#include "hal/stm32g4/register.hpp"

namespace hal::stm32g4 {

/// Independent watchdog, RM0440 42.4.
template <Word W>
struct IwdgRegisters {
  W kr, pr, rlr, sr, winr;
};
static_assert(offsetof(IwdgRegisters<Register>, sr) == 0x0C);

namespace iwdg {
// KR, 42.4.1
inline constexpr std::uint32_t kStart = 0xCCCC, kUnlock = 0x5555, kReload = 0xAAAA;
// PR, 42.4.2
inline constexpr std::uint32_t kDivideBy32 = 3;
}  // namespace iwdg

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
