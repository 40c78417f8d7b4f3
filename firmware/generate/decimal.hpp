#pragma once

#include <fmt/format.h>

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace protocol::generate {

/// A decimal as a whole number of its last place.
struct Scaled {
  std::uint64_t value = 0;
  std::size_t places = 0;
};

inline Scaled scaled(std::string_view decimal) {
  const std::size_t point = decimal.find('.');
  std::string digits(decimal.substr(0, point));
  Scaled result;
  if (point != std::string_view::npos) {
    digits += decimal.substr(point + 1);
    result.places = decimal.size() - point - 1;
  }
  std::from_chars(digits.data(), digits.data() + digits.size(), result.value);
  return result;
}

/// `count` times a decimal without exponent, exactly, as such a decimal.
inline std::string times(std::uint32_t count, std::string_view decimal) {
  const auto [value, places] = scaled(decimal);
  const std::string digits = fmt::format("{:0{}}", count * value, places + 1);
  const std::string_view whole = std::string_view(digits).substr(0, digits.size() - places);
  std::string_view fraction = std::string_view(digits).substr(whole.size());
  fraction = fraction.substr(0, fraction.find_last_not_of('0') + 1);
  return fraction.empty() ? std::string(whole) : fmt::format("{}.{}", whole, fraction);
}

/// The decimal as people read it: 0.000000001 is 1e-9.
inline std::string readable(std::string_view decimal) {
  const auto [value, places] = scaled(decimal);
  return places > 3 ? fmt::format("{}e-{}", value, places) : std::string(decimal);
}

}  // namespace protocol::generate
