#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>

#include "tests/virtual_g431/board/agenda.hpp"
#include "tests/virtual_g431/board/clocks.hpp"
#include "tests/virtual_g431/board/peripheral.hpp"

namespace virtual_g431 {

/// What TIM1 and TIM2 share of a timer that counts its clock, RM0440 28, 29. Without interrupts.
class Timer : public Peripheral {
 public:
  Timer(Agenda& agenda, Rules& rules, std::string name)
      : agenda_(agenda), rules_(rules), name_(std::move(name)) {}

  std::uint32_t read(std::uint32_t offset) override {
    if (offset == 0x24) {
      return count();
    }
    if (offset > 0x44 || offset % 4 != 0) {
      rules_.broken(name_ + ": read of " + hex(offset));
      return 0;
    }
    return registers_[offset / 4];
  }
  void write(std::uint32_t offset, std::uint32_t value) override {
    if (offset > 0x44 || offset % 4 != 0 || offset == 0x24) {
      rules_.broken(name_ + ": write of " + hex(offset));
      return;
    }
    const bool ran = running();
    if (offset == 0x14) {
      rules_.require(value == 1, name_ + ": EGR with " + hex(value));
      prescaler_ = registers_[10];
      began_ = agenda_.now();
      return;
    }
    registers_[offset / 4] = value;
    if (running() && !ran) {
      began_ = agenda_.now();
      started();
    }
  }
  void reset() override {
    registers_ = {};
    registers_[11] = 0xFFFFFFFF;
    prescaler_ = 0;
  }

 protected:
  /// Ticks of one count.
  [[nodiscard]] Ticks period() const { return clock() * (prescaler_ + 1); }
  [[nodiscard]] bool running() const { return (registers_[0] & 1) != 0; }
  [[nodiscard]] std::uint32_t at(std::uint32_t offset) const { return registers_[offset / 4]; }
  [[nodiscard]] virtual Ticks clock() const = 0;
  virtual void started() = 0;
  [[nodiscard]] virtual std::uint32_t count() const {
    return running() ? static_cast<std::uint32_t>((agenda_.now() - began_) / period()) : 0;
  }

  Agenda& agenda_;
  Rules& rules_;
  std::string name_;
  Ticks began_ = 0;

 private:
  std::array<std::uint32_t, 18> registers_{};
  std::uint32_t prescaler_ = 0;
};

/// TIM2, 32 bits, on PCLK1.
class MicrosecondTimer : public Timer {
 public:
  MicrosecondTimer(Agenda& agenda, Rules& rules, const Clocks& clocks)
      : Timer(agenda, rules, "TIM2"), clocks_(clocks) {}

 protected:
  [[nodiscard]] Ticks clock() const override { return clocks_.pclk1(); }
  void started() override {
    rules_.require(at(0x2C) == 0xFFFFFFFF && (at(0x00) & 0x70) == 0,
                   name_ + ": started in a way that is not modelled");
  }

 private:
  const Clocks& clocks_;
};

/// TIM1, centre-aligned on PCLK2, whose OC4REF in PWM mode 2 leaves by TRGO2 (RM0440 28.3.27).
class TriggerTimer : public Timer {
 public:
  TriggerTimer(Agenda& agenda, Rules& rules, const Clocks& clocks)
      : Timer(agenda, rules, "TIM1"), clocks_(clocks) {}

  void write(std::uint32_t offset, std::uint32_t value) override {
    // The gates of the bridge stay off.
    rules_.require((offset != 0x20 && offset != 0x44) || value == 0, "TIM1: an output enabled");
    Timer::write(offset, value);
  }
  void reset() override {
    Timer::reset();
    ++life_;
  }

  /// Rising edges of TRGO2.
  std::function<void()> on_trigger = [] {};
  /// As where the timer or its way to the converters is broken.
  bool dead = false;

 protected:
  [[nodiscard]] Ticks clock() const override { return clocks_.pclk2(); }
  void started() override {
    rules_.require(field(at(0x00), 6, 5) != 0, "TIM1: not centre-aligned");
    rules_.require(field(at(0x04), 23, 20) == 7, "TIM1: TRGO2 is not OC4REF");
    rules_.require(field(at(0x1C), 14, 12) == 7 && (at(0x1C) & bit(24)) == 0,
                   "TIM1: channel 4 not in PWM mode 2");
    rules_.require(at(0x2C) <= 0xFFFF && at(0x40) < at(0x2C) && at(0x40) > 0,
                   "TIM1: compare value out of the count");
    // PWM mode 2: active from the compare value upwards until it is met on the way down.
    schedule(began_ + at(0x40) * period());
  }

 private:
  void schedule(Ticks time) {
    agenda_.at(time, [this, time, life = life_] {
      if (life != life_ || !running()) {
        return;
      }
      if (!dead) {
        on_trigger();
      }
      schedule(time + 2 * at(0x2C) * period());
    });
  }

  const Clocks& clocks_;
  std::uint64_t life_ = 0;
};

}  // namespace virtual_g431
