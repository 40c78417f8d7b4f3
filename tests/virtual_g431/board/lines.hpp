#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "tests/virtual_g431/board/peripheral.hpp"

namespace virtual_g431 {

/// One port of general-purpose lines with what is connected to them, RM0440 9.
class Port : public Peripheral {
 public:
  /// Registers after reset, RM0440 9.4; lines of the debugger differ from the others.
  struct AfterReset {
    std::uint32_t moder = 0xFFFFFFFF, ospeedr = 0, pupdr = 0;
  };

  Port(Rules& rules, std::string name, AfterReset after_reset)
      : rules_(rules), name_(std::move(name)), after_reset_(after_reset) {
    Port::reset();
  }

  std::uint32_t read(std::uint32_t offset) override {
    if (offset == 0x10) {
      std::uint32_t levels = 0;
      for (unsigned line = 0; line < 16; ++line) {
        // The digital input is off where the line is analog (RM0440 9.3.13).
        levels |= mode(line) != 3 && level(line) ? bit(line) : 0;
      }
      return levels;
    }
    if (offset > 0x24 || offset % 4 != 0 || offset == 0x18) {
      rules_.broken(name_ + ": read of " + hex(offset));
      return 0;
    }
    return registers_[offset / 4];
  }
  void write(std::uint32_t offset, std::uint32_t value) override {
    switch (offset) {
      case 0x18:
        odr() = (odr() & ~(value >> 16)) | (value & 0xFFFF);
        break;
      case 0x28:
        odr() &= ~(value & 0xFFFF);
        break;
      case 0x10:
        rules_.broken(name_ + ": write of IDR");
        break;
      default:
        if (offset > 0x24 || offset % 4 != 0) {
          rules_.broken(name_ + ": write of " + hex(offset));
          return;
        }
        registers_[offset / 4] = value;
    }
    on_change();
  }
  void reset() override {
    registers_ = {};
    registers_[0] = after_reset_.moder;
    registers_[2] = after_reset_.ospeedr;
    registers_[3] = after_reset_.pupdr;
    on_change();
  }

  /// 0 input, 1 output, 2 alternate function, 3 analog.
  [[nodiscard]] std::uint32_t mode(unsigned line) const {
    return field(registers_[0], 2 * line + 1, 2 * line);
  }
  [[nodiscard]] std::uint32_t function(unsigned line) const {
    return field(registers_[8 + line / 8], 4 * (line % 8) + 3, 4 * (line % 8));
  }
  /// Of the pin, by whoever is strongest: a short, the driver, what is outside, the weak pull.
  [[nodiscard]] bool level(unsigned line) const {
    if (shorted_[line]) {
      return *shorted_[line];
    }
    if (mode(line) == 1) {
      return (registers_[5] >> line & 1) != 0;
    }
    if (outside_[line]) {
      return *outside_[line];
    }
    return field(registers_[3], 2 * line + 1, 2 * line) == 1;
  }
  /// A resistor, a contact or another driver.
  void connect(unsigned line, std::optional<bool> level) {
    outside_[line] = level;
    on_change();
  }
  /// A short circuit that is stronger than the driver.
  void shorten(unsigned line, std::optional<bool> level) {
    shorted_[line] = level;
    on_change();
  }

  std::function<void()> on_change = [] {};

 private:
  std::uint32_t& odr() { return registers_[5]; }

  Rules& rules_;
  std::string name_;
  AfterReset after_reset_;
  std::array<std::uint32_t, 10> registers_{};
  std::array<std::optional<bool>, 16> outside_{};
  std::array<std::optional<bool>, 16> shorted_{};
};

}  // namespace virtual_g431
