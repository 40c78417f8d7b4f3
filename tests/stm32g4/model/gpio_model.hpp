#pragma once

#include <vector>

#include "hal/stm32g4/pins.hpp"
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

}  // namespace stm32g4_models
