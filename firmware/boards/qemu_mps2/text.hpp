#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace boards::qemu_mps2 {

/// Text of bounded length, put together without the C library. What does not fit is cut off.
template <std::size_t kCapacity>
class Text {
 public:
  Text& operator<<(const char* text) {
    while (*text != '\0') {
      put(*text++);
    }
    return *this;
  }
  Text& operator<<(std::uint32_t value) { return decimal(value, 1); }

  /// At least `digits` decimal digits.
  Text& decimal(std::uint32_t value, std::size_t digits) {
    std::array<char, 10> reversed{};
    std::size_t count = 0;
    do {
      reversed[count++] = static_cast<char>('0' + value % 10);
      value /= 10;
    } while (value != 0 || count < digits);
    while (count > 0) {
      put(reversed[--count]);
    }
    return *this;
  }

  /// Eight hexadecimal digits.
  Text& hex(std::uint32_t value) {
    for (int shift = 28; shift >= 0; shift -= 4) {
      put("0123456789abcdef"[(value >> shift) & 15u]);
    }
    return *this;
  }

  [[nodiscard]] const char* c_str() const { return text_.data(); }
  [[nodiscard]] std::size_t size() const { return size_; }

 private:
  void put(char c) {
    if (size_ < kCapacity) {
      text_[size_++] = c;
    }
  }

  std::size_t size_ = 0;
  std::array<char, kCapacity + 1> text_{};
};

}  // namespace boards::qemu_mps2
