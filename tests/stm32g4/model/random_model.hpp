#pragma once

#include "hal/stm32g4/random.hpp"
#include "tests/stm32g4/model/rcc_model.hpp"
#include "tests/stm32g4/model/word.hpp"

namespace stm32g4_models {

/// RM0440 chapter 26, with words that a test can foretell.
class RandomModel : public RegisterModel<hal::stm32g4::RngRegisters<Word>> {
 public:
  explicit RandomModel(const RccModel& rcc) : rcc_(rcc) {}

  std::uint32_t next = 0x04030201;
  /// Whether a seed error is over after the sequence of 26.3.7.
  bool recovers = true;

  /// The noise source gave what is not random.
  void break_seed() {
    registers.sr.raise(1u << 6 | 1u << 2);
    discard_ = 12;
  }
  /// The clock was too slow.
  void break_clock() { registers.sr.raise(1u << 5 | 1u << 1); }
  void mend_clock() { registers.sr.drop(1u << 1); }

  std::uint32_t on_read(const Word& word) override {
    check_clock();
    if (&word == &registers.sr && ready_.due() && discard_ == 0 && !registers.sr.has(1u << 1)) {
      registers.sr.raise(1);
    }
    if (&word == &registers.dr) {
      return take();
    }
    return word.held();
  }
  void on_write(Word& word, std::uint32_t value) override {
    check_clock();
    if (&word == &registers.sr) {
      registers.sr.drop(~value & (1u << 5 | 1u << 6));
      return;
    }
    word.hold(value);
    ready_.begin(4);
  }

 private:
  void check_clock() const {
    EXPECT_TRUE(rcc_.enabled(rcc_.registers.ahb2enr, 1u << 26)) << "RNG without its clock";
    EXPECT_TRUE(rcc_.registers.crrcr.has(2)) << "RNG without its 48 MHz";
  }
  std::uint32_t take() {
    if (discard_ != 0) {
      if (--discard_ == 0) {
        if (recovers) {
          registers.sr.drop(1u << 2);
          ready_.begin(4);
        } else {
          break_seed();
        }
      }
      return 0;
    }
    EXPECT_TRUE(registers.sr.has(1)) << "a word before DRDY (26.3.5)";
    registers.sr.drop(1);
    ready_.begin(4);
    const std::uint32_t word = next;
    next += 0x04040404;
    return word;
  }

  const RccModel& rcc_;
  Delayed ready_;
  unsigned discard_ = 0;
};

}  // namespace stm32g4_models
