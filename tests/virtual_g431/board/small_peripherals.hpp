#pragma once

#include <cstdint>
#include <functional>
#include <random>

#include "tests/virtual_g431/board/agenda.hpp"
#include "tests/virtual_g431/board/clocks.hpp"
#include "tests/virtual_g431/board/peripheral.hpp"

namespace virtual_g431 {

/// Random number generator, RM0440 26.
class NoiseSource : public Peripheral {
 public:
  NoiseSource(Agenda& agenda, Rules& rules, const Clocks& clocks)
      : agenda_(agenda), rules_(rules), clocks_(clocks) {}

  std::uint32_t read(std::uint32_t offset) override {
    const bool on = (cr_ & bit(2)) != 0;
    const bool clocked = clocks_.has_48MHz();
    const bool ready = on && clocked && !broken && agenda_.now() >= ready_at_;
    switch (offset) {
      case 0x00:
        return cr_;
      case 0x04:
        return (ready ? 1u : 0u) | (on && !clocked ? bit(1) | bit(5) : 0u) |
               (broken ? bit(2) | bit(6) : 0u);
      case 0x08:
        if (!ready) {
          return 0;
        }
        ready_at_ = agenda_.now() + 412 * clocks_.hclk();
        return static_cast<std::uint32_t>(random_());
      default:
        rules_.broken("RNG: read of " + hex(offset));
        return 0;
    }
  }
  void write(std::uint32_t offset, std::uint32_t value) override {
    rules_.require(offset <= 4, "RNG: write of " + hex(offset));
    if (offset == 0) {
      cr_ = value;
      ready_at_ = agenda_.now() + 412 * clocks_.hclk();
    }
  }
  void reset() override { cr_ = 0; }

  /// The noise fails its tests (RM0440 26.3.7).
  bool broken = false;

 private:
  Agenda& agenda_;
  Rules& rules_;
  const Clocks& clocks_;
  std::uint32_t cr_ = 0;
  Ticks ready_at_ = 0;
  std::mt19937 random_{1};
};

/// Independent watchdog on LSI, 32 kHz, RM0440 42. Nothing but a reset stops it.
class Watchdog : public Peripheral {
 public:
  Watchdog(Agenda& agenda, Rules& rules) : agenda_(agenda), rules_(rules) {}

  std::uint32_t read(std::uint32_t offset) override {
    switch (offset) {
      case 0x04:
        return prescaler_;
      case 0x08:
        return reload_;
      case 0x0C:
        return agenda_.now() < taken_over_at_ ? 3 : 0;
      default:
        rules_.broken("IWDG: read of " + hex(offset));
        return 0;
    }
  }
  void write(std::uint32_t offset, std::uint32_t value) override {
    if (offset == 0x00) {
      open_ = value == 0x5555;
      if (value == 0xCCCC) {
        on_ = true;
      }
      if (on_ && (value == 0xCCCC || value == 0xAAAA)) {
        feed();
      }
      return;
    }
    rules_.require(offset == 0x04 || offset == 0x08, "IWDG: write of " + hex(offset));
    rules_.require(open_, "IWDG: written without its key");
    rules_.require(offset != 0x08 || value <= 0xFFF, "IWDG: RLR of more than 12 bits");
    if (open_ && offset <= 0x08) {
      (offset == 0x04 ? prescaler_ : reload_) = value;
      // Five cycles of LSI, divided, in its own domain (RM0440 42.4.4).
      taken_over_at_ = agenda_.now() + 5 * (Ticks{4} << prescaler_) * kCycle;
    }
  }
  void reset() override {
    agenda_.cancel(end_);
    on_ = open_ = false;
    prescaler_ = 0;
    reload_ = 0xFFF;
    taken_over_at_ = 0;
  }

  [[nodiscard]] bool on() const { return on_; }
  std::function<void()> on_timeout = [] {};

 private:
  static constexpr Ticks kCycle = kSecond / 32'000;

  void feed() {
    agenda_.cancel(end_);
    end_ = agenda_.in((Ticks{4} << prescaler_) * (reload_ + 1) * kCycle, [this] { on_timeout(); });
  }

  Agenda& agenda_;
  Rules& rules_;
  bool on_ = false;
  bool open_ = false;
  std::uint32_t prescaler_ = 0;
  std::uint32_t reload_ = 0xFFF;
  Ticks taken_over_at_ = 0;
  Agenda::Entry end_{};
};

}  // namespace virtual_g431
