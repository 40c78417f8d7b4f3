#pragma once

#include <vector>

#include "hal/stm32g4/pins.hpp"
#include "hal/stm32g4/random.hpp"
#include "hal/stm32g4/watchdog.hpp"
#include "tests/stm32g4/model/rcc_model.hpp"
#include "tests/stm32g4/model/word.hpp"

namespace stm32g4_models {

/// RM0440 chapter 9: one port, with what is connected to it.
class GpioModel : public RegisterModel<hal::stm32g4::GpioRegisters<Word>> {
 public:
  GpioModel(const RccModel& rcc, std::uint32_t enable) : rcc_(rcc), enable_(enable) {
    registers.moder.hold(0xFFFFFFFF);
  }

  /// Levels from outside, and lines that are held there whatever the pin drives.
  std::uint32_t outside = 0;
  std::uint32_t shorted = 0;
  /// Levels that each line has driven since it became an output.
  std::vector<std::pair<unsigned, bool>> driven;

  [[nodiscard]] std::uint32_t mode(unsigned line) const {
    return registers.moder.held() >> (2 * line) & 3u;
  }
  [[nodiscard]] std::uint32_t function(unsigned line) const {
    return registers.afr[line / 8].held() >> (4 * (line % 8)) & 15u;
  }
  /// The level of a line that is driven.
  [[nodiscard]] bool drives(unsigned line) const {
    EXPECT_EQ(mode(line), 1u) << "line " << line << " is not an output";
    return (registers.odr.held() >> line & 1u) != 0;
  }

  std::uint32_t on_read(const Word& word) override {
    check_clock();
    if (&word == &registers.idr) {
      std::uint32_t level = 0;
      for (unsigned line = 0; line < 16; ++line) {
        const bool pin = mode(line) == 1 && (shorted >> line & 1u) == 0;
        level |= ((pin ? registers.odr.held() : outside) >> line & 1u) << line;
      }
      return level;
    }
    EXPECT_TRUE(&word != &registers.bsrr && &word != &registers.brr) << "write only";
    return word.held();
  }
  void on_write(Word& word, std::uint32_t value) override {
    check_clock();
    if (&word == &registers.bsrr) {
      registers.odr.hold((registers.odr.held() & ~(value >> 16)) | (value & 0xFFFFu));
      note(value | value >> 16);
      return;
    }
    EXPECT_NE(&word, &registers.idr) << "read only";
    const std::uint32_t before = registers.moder.held();
    word.hold(value);
    if (&word == &registers.moder) {
      for (unsigned line = 0; line < 16; ++line) {
        if ((before >> (2 * line) & 3u) != 1) {
          note(1u << line);
        }
      }
    }
  }

 private:
  void check_clock() const {
    EXPECT_TRUE(rcc_.enabled(rcc_.registers.ahb2enr, enable_)) << "a port without its clock";
  }
  void note(std::uint32_t lines) {
    for (unsigned line = 0; line < 16; ++line) {
      if ((lines >> line & 1u) != 0 && mode(line) == 1) {
        driven.emplace_back(line, (registers.odr.held() >> line & 1u) != 0);
      }
    }
  }

  const RccModel& rcc_;
  std::uint32_t enable_;
};

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
