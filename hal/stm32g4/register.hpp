#pragma once

#include <concepts>
#include <cstdint>

#include "hal/error.hpp"

namespace hal::stm32g4 {

/// A 32-bit register of the device, in its place in memory.
class Register {
 public:
  [[nodiscard]] std::uint32_t read() const { return value_; }
  void write(std::uint32_t value) { value_ = value; }

 private:
  volatile std::uint32_t value_;
};

/// What register files are made of: Register on the device, words that react on a host.
template <class T>
concept Word = sizeof(T) == 4 && requires(T& word, const T& constant, std::uint32_t value) {
  { constant.read() } -> std::same_as<std::uint32_t>;
  { word.write(value) } -> std::same_as<void>;
};

constexpr std::uint32_t bit(unsigned position) {
  return std::uint32_t{1} << position;
}

template <Word W>
void set_bits(W& word, std::uint32_t mask) {
  word.write(word.read() | mask);
}

template <Word W>
void clear_bits(W& word, std::uint32_t mask) {
  word.write(word.read() & ~mask);
}

/// @pre `value` has no bit outside `mask`
template <Word W>
void replace_bits(W& word, std::uint32_t mask, std::uint32_t value) {
  word.write((word.read() & ~mask) | value);
}

/// Reads at most `polls` times until the bits of `mask` are `value`; failed if they never are.
template <Word W>
Error wait_until(const W& word, std::uint32_t mask, std::uint32_t value, std::uint32_t polls) {
  for (std::uint32_t i = 0; i < polls; ++i) {
    if ((word.read() & mask) == value) {
      return Error::none;
    }
  }
  return Error::failed;
}

}  // namespace hal::stm32g4
