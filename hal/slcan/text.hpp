#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "hal/slcan/hex.hpp"

namespace hal::slcan {

/// The longest line without its end: `T`, 8 digits of id, 1 of length, 16 of data.
inline constexpr std::size_t kLongestLine = 26;

/// Ends a line, and as an answer says yes.
inline constexpr char kEnd = '\r';
/// As an answer: no.
inline constexpr char kBell = '\a';

/// A line of bounded length with its end. Precondition of put(): it fits.
class Text {
 public:
  constexpr void put(char c) { characters_[size_++] = c; }
  constexpr void put_hex(std::uint32_t value, int digits) {
    for (int shift = 4 * (digits - 1); shift >= 0; shift -= 4) {
      put(hex_digit((value >> shift) & 15u));
    }
  }
  [[nodiscard]] constexpr std::string_view view() const { return {characters_.data(), size_}; }
  [[nodiscard]] std::span<const std::byte> bytes() const {
    return std::as_bytes(std::span(characters_).first(size_));
  }

 private:
  std::array<char, kLongestLine + 1> characters_{};
  std::size_t size_ = 0;
};

}  // namespace hal::slcan
