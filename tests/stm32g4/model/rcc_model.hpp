#pragma once

#include "hal/stm32g4/clock_tree.hpp"
#include "hal/stm32g4/flash_memory.hpp"
#include "tests/stm32g4/model/word.hpp"

namespace stm32g4_models {

/// What the clocks hang on beside RCC itself; see PowerModel and FlashModel.
struct Supply {
  bool boosted = false;
  std::uint32_t wait_states = 0;
};

/// RM0440 chapter 7.
class RccModel : public RegisterModel<hal::stm32g4::RccRegisters<Word>> {
 public:
  explicit RccModel(const Supply& supply) : supply_(supply) {
    registers.cr.hold(0x500);  // HSI16 on and ready
    registers.cfgr.hold(0x05);
    registers.pllcfgr.hold(0x1000);
  }

  bool crystal = true;
  bool pll_locks = true;

  [[nodiscard]] bool enabled(const Word& enable, std::uint32_t mask) const {
    return enable.has(mask);
  }
  [[nodiscard]] std::uint32_t core_Hz() const {
    if ((registers.cfgr.held() >> 2 & 3u) != 3) {
      return 16'000'000;
    }
    return pll_Hz() / ((registers.cfgr.held() >> 4 & 15u) == 8 ? 2 : 1);
  }
  [[nodiscard]] std::uint32_t pll_Hz() const {
    const std::uint32_t c = registers.pllcfgr.held();
    const std::uint32_t source_Hz = (c & 3u) == 3 ? 8'000'000 : (c & 3u) == 2 ? 16'000'000 : 0;
    const std::uint32_t input_Hz = source_Hz / ((c >> 4 & 15u) + 1);
    const std::uint32_t vco_Hz = input_Hz * (c >> 8 & 0x7Fu);
    EXPECT_TRUE(input_Hz >= 2'660'000 && input_Hz <= 16'000'000) << "PLL input of RM0440 7.2.4";
    EXPECT_TRUE(vco_Hz >= 96'000'000 && vco_Hz <= 344'000'000) << "VCO range of DS12589";
    return (c & 1u << 24) != 0 ? vco_Hz / (((c >> 25 & 3u) + 1) * 2) : 0;
  }
  /// HSE fails: the system clock goes back to HSI16, and the NMI is raised (7.2.12).
  void break_crystal() {
    crystal = false;
    registers.cr.drop(1u << 17 | 1u << 16 | 1u << 24 | 1u << 25);
    registers.cifr.raise(1u << 8);
    registers.cfgr.hold(0x05);
  }

  std::uint32_t on_read(const Word& word) override {
    if (&word == &registers.cr) {
      if (hse_.due() && crystal) {
        registers.cr.raise(1u << 17);
      }
      if (pll_.due()) {
        if (registers.cr.has(1u << 24) && pll_locks) {
          registers.cr.raise(1u << 25);
        } else {
          registers.cr.drop(1u << 25);
        }
      }
    }
    if (&word == &registers.crrcr && hsi48_.due()) {
      registers.crrcr.raise(2);
    }
    if (&word == &registers.cfgr) {
      ++half_speed_reads_;
      if (switch_.due()) {
        registers.cfgr.hold((registers.cfgr.held() & ~12u) | (registers.cfgr.held() & 3u) << 2);
      }
    }
    return word.held();
  }

  void on_write(Word& word, std::uint32_t value) override {
    if (&word == &registers.cr) {
      return write_cr(value);
    }
    if (&word == &registers.pllcfgr) {
      EXPECT_FALSE(registers.cr.has(1u << 24) || registers.cr.has(1u << 25))
          << "the PLL was configured while it is on (7.2.4)";
    }
    if (&word == &registers.cfgr) {
      return write_cfgr(value);
    }
    if (&word == &registers.crrcr && (value & 1u) != 0) {
      hsi48_.begin(3);
      value &= ~2u;
    }
    word.hold(value);
  }

 private:
  void write_cr(std::uint32_t value) {
    const std::uint32_t before = registers.cr.held();
    constexpr std::uint32_t kReadOnly = 1u << 10 | 1u << 17 | 1u << 25;
    if ((value & ~before & 1u << 16) != 0) {
      hse_.begin(5);
    }
    if ((value & 1u << 16) == 0) {
      EXPECT_FALSE(registers.cr.has(1u << 25) && (registers.pllcfgr.held() & 3u) == 3)
          << "HSE was stopped while the PLL runs from it";
      registers.cr.drop(1u << 17);
    }
    if ((value & ~before & 1u << 24) != 0) {
      const bool ready = (registers.pllcfgr.held() & 3u) != 3 || registers.cr.has(1u << 17);
      EXPECT_TRUE(ready) << "the PLL was started before its source is ready";
      EXPECT_NE(registers.pllcfgr.held() & 3u, 0u) << "the PLL was started without a source";
      pll_.begin(5);
    }
    if ((before & ~value & 1u << 24) != 0) {
      EXPECT_NE(registers.cfgr.held() >> 2 & 3u, 3u) << "the PLL was stopped while it is in use";
      pll_.begin(2);
    }
    registers.cr.hold((value & ~kReadOnly) | (registers.cr.held() & kReadOnly));
  }

  void write_cfgr(std::uint32_t value) {
    const std::uint32_t before = registers.cfgr.held();
    const bool half = (before >> 4 & 15u) == 8;
    if ((value & 3u) == 3 && (before & 3u) != 3) {
      EXPECT_TRUE(registers.cr.has(1u << 25)) << "switched to a PLL that is not locked";
      EXPECT_TRUE(half) << "more than 80 MHz without half speed on the way (6.1.5)";
      EXPECT_TRUE(supply_.boosted) << "170 MHz without boost (6.1.5)";
      EXPECT_GE(supply_.wait_states, 4u) << "wait states after the clock rose (5.3.3)";
      switch_.begin(4);
      half_speed_reads_ = 0;
    }
    if ((value & 3u) == 1 && (before & 3u) != 1) {
      EXPECT_TRUE(registers.cr.has(1u << 10)) << "switched to HSI16 while it is off";
      switch_.begin(4);
    }
    if (half && (value >> 4 & 15u) == 0 && (before >> 2 & 3u) == 3) {
      EXPECT_GE(half_speed_reads_, 85u) << "half speed for less than 1 us (6.1.5)";
    }
    registers.cfgr.hold((value & ~12u) | (before & 12u));
  }

  const Supply& supply_;
  Delayed hse_, pll_, hsi48_, switch_;
  unsigned half_speed_reads_ = 0;
};

/// RM0440 chapter 6.
class PowerModel : public RegisterModel<hal::stm32g4::PwrRegisters<Word>> {
 public:
  PowerModel(Supply& supply, const RccModel& rcc) : supply_(supply), rcc_(rcc) {
    registers.cr1.hold(0x200);
    registers.cr5.hold(0x100);
  }

  std::uint32_t on_read(const Word& word) override {
    if (&word == &registers.sr2 && changing_.due()) {
      registers.sr2.drop(1u << 10);
    }
    return word.held();
  }
  void on_write(Word& word, std::uint32_t value) override {
    EXPECT_TRUE(rcc_.enabled(rcc_.registers.apb1enr1, 1u << 28)) << "PWR without its clock";
    if (&word == &registers.cr1) {
      EXPECT_EQ(value >> 9 & 3u, 1u) << "170 MHz needs voltage range 1";
    }
    if (&word == &registers.cr5) {
      supply_.boosted = (value & 1u << 8) == 0;
      registers.sr2.raise(1u << 10);
      changing_.begin(3);
    }
    word.hold(value);
  }

 private:
  Supply& supply_;
  const RccModel& rcc_;
  Delayed changing_;
};

}  // namespace stm32g4_models
