#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "hal/stm32g4/register.hpp"

/// Models of the registers of an STM32G431: they answer as RM0440 says that the device does, and
/// fail the test where software does what RM0440 forbids.
namespace stm32g4_models {

class Word;

/// Something with registers, which hears of every access to them.
class Peripheral {
 public:
  Peripheral(const Peripheral&) = delete;
  Peripheral& operator=(const Peripheral&) = delete;

  virtual std::uint32_t on_read(const Word& word) = 0;
  virtual void on_write(Word& word, std::uint32_t value) = 0;

  /// The peripheral whose registers lie there.
  static Peripheral& at(const void* address) {
    const auto found = std::find_if(all().begin(), all().end(), [&](const Range& range) {
      return !std::less<>()(address, range.first) && std::less<>()(address, range.last);
    });
    EXPECT_NE(found, all().end()) << "an access where there is no register";
    return *found->peripheral;
  }

 protected:
  /// @param first of the registers, whose lifetime may begin later; they are not read here
  Peripheral(void* first, std::size_t size) {
    all().push_back({first, static_cast<const char*>(first) + size, this});
  }
  ~Peripheral() {
    std::erase_if(all(), [this](const Range& range) { return range.peripheral == this; });
  }

 private:
  struct Range {
    const void* first;
    const void* last;
    Peripheral* peripheral;
  };
  static std::vector<Range>& all() {
    static std::vector<Range> ranges;
    return ranges;
  }
};

/// A register of a model.
class Word {
 public:
  [[nodiscard]] std::uint32_t read() const { return Peripheral::at(this).on_read(*this); }
  void write(std::uint32_t value) { Peripheral::at(this).on_write(*this, value); }

  /// What it holds, for the model itself.
  [[nodiscard]] std::uint32_t held() const { return value_; }
  void hold(std::uint32_t value) { value_ = value; }
  [[nodiscard]] bool has(std::uint32_t mask) const { return (value_ & mask) == mask; }
  void raise(std::uint32_t mask) { value_ |= mask; }
  void drop(std::uint32_t mask) { value_ &= ~mask; }

 private:
  std::uint32_t value_ = 0;
};
static_assert(hal::stm32g4::Word<Word>);

/// A peripheral with a register file that reads what was written; models override the rest.
template <class Registers>
class RegisterModel : public Peripheral {
 public:
  Registers registers{};

  std::uint32_t on_read(const Word& word) override { return word.held(); }
  void on_write(Word& word, std::uint32_t value) override { word.hold(value); }

 protected:
  RegisterModel() : Peripheral(&registers, sizeof(Registers)) {}
  ~RegisterModel() = default;
};

/// Something that becomes so after some reads.
class Delayed {
 public:
  void begin(unsigned reads) { left_ = reads; }
  /// True once, when it is time.
  bool due() { return left_ != 0 && --left_ == 0; }
  [[nodiscard]] bool pending() const { return left_ != 0; }

 private:
  unsigned left_ = 0;
};

}  // namespace stm32g4_models
