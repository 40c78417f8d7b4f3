#pragma once

#include "hal/stm32g4/timers.hpp"
#include "tests/stm32g4/model/rcc_model.hpp"
#include "tests/stm32g4/model/word.hpp"

namespace stm32g4_models {

/// RM0440 chapters 28 and 29: a timer whose counter time moves on with each look at it.
class TimerModel : public RegisterModel<hal::stm32g4::TimRegisters<Word>> {
 public:
  TimerModel(const RccModel& rcc, const Word& enable, std::uint32_t mask)
      : rcc_(rcc), enable_(enable), mask_(mask) {}

  /// Microseconds of the whole chip.
  std::uint64_t time_us = 0;

  [[nodiscard]] bool runs() const { return registers.cr1.has(1); }
  [[nodiscard]] std::uint32_t count_Hz() const {
    return rcc_.core_Hz() / (registers.psc.held() + 1);
  }
  /// How often TRGO2 rises; 0 where it does not.
  [[nodiscard]] std::uint32_t trigger_Hz() const {
    const bool centre = (registers.cr1.held() >> 5 & 3u) != 0;
    const bool oc4 = (registers.cr2.held() >> 20 & 15u) == 7 &&
                     (registers.ccmr2.held() >> 12 & 7u) == 7 &&
                     (registers.ccmr2.held() >> 8 & 3u) == 0;
    const std::uint32_t top = registers.arr.held();
    const std::uint32_t compare = registers.ccr[3].held();
    if (!runs() || !centre || !oc4 || top == 0 || compare == 0 || compare > top) {
      return 0;
    }
    return count_Hz() / (2 * top);
  }

  std::uint32_t on_read(const Word& word) override {
    check_clock();
    if (&word == &registers.cnt) {
      if (runs()) {
        EXPECT_EQ(count_Hz(), 1'000'000u) << "a clock that does not count microseconds";
        ++time_us;
      }
      return static_cast<std::uint32_t>(time_us);
    }
    return word.held();
  }
  void on_write(Word& word, std::uint32_t value) override {
    check_clock();
    const bool setup = &word == &registers.cr2 || &word == &registers.ccmr2 ||
                       &word == &registers.psc || &word == &registers.arr;
    EXPECT_FALSE(setup && runs()) << "a timer was set up while it runs";
    if (&word == &registers.cr1 && runs()) {
      EXPECT_EQ(value >> 5 & 3u, registers.cr1.held() >> 5 & 3u)
          << "the alignment was changed while the timer runs (28.6.1)";
    }
    word.hold(value);
    if (&word == &registers.egr) {
      time_us = 0;
    }
  }

 private:
  void check_clock() const {
    EXPECT_TRUE(rcc_.enabled(enable_, mask_)) << "a timer without its clock";
  }
  const RccModel& rcc_;
  const Word& enable_;
  std::uint32_t mask_;
};

}  // namespace stm32g4_models
