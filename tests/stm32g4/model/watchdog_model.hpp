#pragma once

#include "hal/stm32g4/watchdog.hpp"
#include "tests/stm32g4/model/word.hpp"

namespace stm32g4_models {

/// RM0440 chapter 42.
class WatchdogModel : public RegisterModel<hal::stm32g4::IwdgRegisters<Word>> {
 public:
  WatchdogModel() { registers.rlr.hold(0xFFF); }

  bool answers = true;

  [[nodiscard]] bool started() const { return started_; }
  [[nodiscard]] std::uint32_t period_ms() const {
    return (registers.rlr.held() + 1) * (4u << registers.pr.held()) / 32;
  }
  /// Time goes by on LSI.
  void pass(std::uint32_t ms) { left_ms_ -= std::min(left_ms_, started_ ? ms : 0); }
  [[nodiscard]] bool bitten() const { return started_ && left_ms_ == 0; }

  std::uint32_t on_read(const Word& word) override {
    EXPECT_NE(&word, &registers.kr) << "write only";
    if (&word == &registers.sr && taken_.due() && answers) {
      registers.sr.hold(0);
    }
    return word.held();
  }
  void on_write(Word& word, std::uint32_t value) override {
    if (&word == &registers.kr) {
      unlocked_ = value == 0x5555;
      started_ = started_ || value == 0xCCCC;
      if (value == 0xAAAA || value == 0xCCCC) {
        left_ms_ = period_ms();
      }
      return;
    }
    EXPECT_TRUE(unlocked_) << "PR and RLR are protected (42.3.5)";
    EXPECT_TRUE(started_) << "the values are taken over by LSI, which runs once it is started";
    registers.sr.raise(3);
    taken_.begin(6);
    word.hold(value);
  }

 private:
  bool started_ = false;
  bool unlocked_ = false;
  std::uint32_t left_ms_ = 0;
  Delayed taken_;
};

}  // namespace stm32g4_models
