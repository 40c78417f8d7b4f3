#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace hal::slcan {

/// The digit that Linux' slcan writes: upper case. Precondition: value < 16.
constexpr char hex_digit(std::uint32_t value) {
  return static_cast<char>(value < 10 ? '0' + value : 'A' + value - 10);
}

/// Of either case.
constexpr std::optional<std::uint32_t> hex_value(char digit) {
  if (digit >= '0' && digit <= '9') {
    return static_cast<std::uint32_t>(digit - '0');
  }
  if (digit >= 'A' && digit <= 'F') {
    return static_cast<std::uint32_t>(digit - 'A' + 10);
  }
  if (digit >= 'a' && digit <= 'f') {
    return static_cast<std::uint32_t>(digit - 'a' + 10);
  }
  return std::nullopt;
}

/// A number of at most 8 digits and nothing else.
constexpr std::optional<std::uint32_t> hex_number(std::string_view digits) {
  std::uint32_t number = 0;
  for (const char digit : digits) {
    const auto value = hex_value(digit);
    if (!value) {
      return std::nullopt;
    }
    number = (number << 4) | *value;
  }
  return number;
}

}  // namespace hal::slcan
