#pragma once

#include <array>

#include "hal/stm32g4/current_sensor.hpp"
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

/// RM0440 chapter 25: the amplifiers of the shunts.
class OpampModel : public RegisterModel<hal::stm32g4::OpampRegisters<Word>> {
 public:
  explicit OpampModel(const RccModel& rcc) : rcc_(rcc) {}

  /// What each amplifier gives out, in counts of a converter.
  std::array<std::uint32_t, 3> output{2048, 2048, 2048};

  /// Gain 16 in high-speed mode, VINP0 and VINM0, into the converter.
  [[nodiscard]] bool ready(std::size_t i) const {
    return (registers.csr[i].held() & ~1u) == (2u << 5 | 1u << 7 | 1u << 8 | 0x0Bu << 14) &&
           registers.csr[i].has(1);
  }
  void on_write(Word& word, std::uint32_t value) override {
    EXPECT_TRUE(rcc_.enabled(rcc_.registers.apb2enr, 1)) << "OPAMP without the clock of SYSCFG";
    if (word.has(1)) {
      EXPECT_EQ(word.held() | 1u, value | 1u) << "an amplifier was changed while it is on";
    }
    word.hold(value);
  }

 private:
  const RccModel& rcc_;
};

class AdcCommonModel : public RegisterModel<hal::stm32g4::AdcCommonRegisters<Word>> {
 public:
  bool any_enabled = false;
  void on_write(Word& word, std::uint32_t value) override {
    EXPECT_FALSE(any_enabled) << "the common part was set up while a converter is on (21.7.2)";
    word.hold(value);
  }
};

/// RM0440 chapter 21: one converter.
class AdcModel : public RegisterModel<hal::stm32g4::AdcRegisters<Word>> {
 public:
  AdcModel(const RccModel& rcc, AdcCommonModel& common, const TimerModel& clock,
           const TimerModel& trigger)
      : rcc_(rcc), common_(common), clock_(clock), trigger_(trigger) {
    registers.cr.hold(1u << 29);
    registers.cfgr.hold(1u << 31);
  }

  bool calibrates = true;
  /// Looks at ISR until the next trigger; 0: trigger() is called by the test.
  unsigned looks_a_trigger = 4;
  std::function<void()> on_trigger;
  /// What the first conversion after the calibration gives: that of channel 0, or nothing that is
  /// right (ES0431 2.5.7, 2.5.8).
  std::uint32_t first = 0;

  /// TIM1 triggers; `channel` gives what is on a channel.
  template <class Channel>
  void trigger(Channel&& channel) {
    const std::uint32_t jsqr = registers.jsqr.held();
    if (!registers.cr.has(1u << 3) || (jsqr >> 2 & 0x1Fu) != 8 || (jsqr >> 7 & 3u) != 1 ||
        trigger_.trigger_Hz() == 0) {
      return;
    }
    for (unsigned rank = 0; rank <= (jsqr & 3u); ++rank) {
      const std::uint32_t wanted = channel(jsqr >> (9 + 6 * rank) & 0x1Fu);
      registers.jdr[rank].hold(fresh_ ? first : wanted);
      fresh_ = false;
    }
    registers.isr.raise(1u << 5 | 1u << 6);
  }

  std::uint32_t on_read(const Word& word) override {
    check_clock();
    if (&word == &registers.cr && calibration_.due()) {
      registers.cr.drop(1u << 31);
      calibrated_ = true;
      calibrated_us_ = clock_.time_us;
    }
    if (&word == &registers.isr) {
      if (ready_.due()) {
        registers.isr.raise(1);
      }
      if (looks_a_trigger != 0 && on_trigger && ++looks_ % looks_a_trigger == 0) {
        on_trigger();
      }
    }
    return word.held();
  }

  void on_write(Word& word, std::uint32_t value) override {
    check_clock();
    if (&word == &registers.isr) {
      registers.isr.drop(value);
      return;
    }
    if (&word == &registers.cr) {
      return write_cr(value);
    }
    const bool setup = &word == &registers.smpr[0] || &word == &registers.smpr[1] ||
                       &word == &registers.jsqr || &word == &registers.cfgr;
    EXPECT_FALSE(setup && registers.cr.has(1u << 3)) << "set up while conversions run (21.4.10)";
    EXPECT_FALSE(&word == &registers.ier && registers.cr.has(1u << 3))
        << "an interrupt of injected conversions was chosen while they run (21.6.2)";
    word.hold(value);
  }

 private:
  void check_clock() const {
    EXPECT_TRUE(rcc_.enabled(rcc_.registers.ahb2enr, 1u << 13)) << "ADC without its clock";
  }

  void write_cr(std::uint32_t value) {
    const std::uint32_t before = registers.cr.held();
    const std::uint32_t rising = value & ~before;
    if ((value & 1u << 28) != 0) {
      EXPECT_EQ(value & 1u << 29, 0u) << "the regulator in deep power-down (21.4.6)";
      EXPECT_FALSE((rising & 1u << 28) != 0 && (before & 1u << 29) != 0)
          << "the regulator together with leaving deep power-down (21.4.6)";
    }
    if ((rising & 1u << 28) != 0) {
      regulator_us_ = clock_.time_us;
    }
    if ((rising & 1u << 31) != 0) {
      start_calibration(value);
    }
    if ((rising & 1u) != 0) {
      EXPECT_TRUE(calibrated_) << "enabled before it is calibrated (21.4.8)";
      EXPECT_FALSE(calibration_.pending()) << "enabled while it calibrates (21.4.9)";
      EXPECT_GT(clock_.time_us, calibrated_us_) << "enabled within 4 cycles (21.4.8)";
      EXPECT_FALSE(registers.isr.has(1)) << "ADRDY was not cleared (21.4.9)";
      common_.any_enabled = true;
      ready_.begin(3);
    }
    if ((rising & 1u << 3) != 0) {
      EXPECT_TRUE(registers.isr.has(1)) << "conversions before ADRDY (21.4.9)";
    }
    EXPECT_EQ(value & (1u << 1 | 1u << 2 | 1u << 4 | 1u << 5), 0u) << "not meant";
    registers.cr.hold(value | (before & (1u << 31 | 1u << 3 | 1u)));
  }

  void start_calibration(std::uint32_t cr) {
    EXPECT_NE(cr & 1u << 28, 0u) << "calibration without the regulator (21.4.8)";
    EXPECT_EQ(cr & 1u, 0u) << "calibration while it is enabled (21.4.8)";
    EXPECT_GE(clock_.time_us - regulator_us_, 20u) << "the regulator is not up (21.4.6)";
    EXPECT_NE(common_.registers.ccr.held() >> 16 & 3u, 0u) << "no clock for the converter";
    if (calibrates) {
      calibration_.begin(10);
    }
  }

  const RccModel& rcc_;
  AdcCommonModel& common_;
  const TimerModel& clock_;
  const TimerModel& trigger_;
  Delayed calibration_, ready_;
  bool calibrated_ = false;
  bool fresh_ = true;
  std::uint64_t regulator_us_ = 0;
  std::uint64_t calibrated_us_ = 0;
  unsigned looks_ = 0;
};

}  // namespace stm32g4_models
