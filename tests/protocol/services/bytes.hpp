#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "hal/can_frame.hpp"

namespace protocol::testing {

using Bytes = std::vector<std::byte>;

/// Bytes out of hexadecimal digits; spaces are for the reader.
inline Bytes hex(std::string_view text) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  Bytes result;
  bool half = false;
  for (const char c : text) {
    if (c == ' ') {
      continue;
    }
    const auto digit = static_cast<std::uint8_t>(kDigits.find(c));
    if (half) {
      result.back() |= std::byte{digit};
    } else {
      result.push_back(static_cast<std::byte>(digit << 4));
    }
    half = !half;
  }
  return result;
}

/// The same where the length is known.
template <class Array>
Array hex_array(std::string_view text) {
  const Bytes bytes = hex(text);
  Array result{};
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] = bytes.at(i);
  }
  return result;
}

inline Bytes to_bytes(std::span<const std::byte> bytes) {
  return {bytes.begin(), bytes.end()};
}

inline Bytes operator+(Bytes a, const Bytes& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// 0, 1, 2 ...
inline Bytes counting(std::size_t size) {
  Bytes result;
  for (std::size_t i = 0; i < size; ++i) {
    result.push_back(static_cast<std::byte>(i));
  }
  return result;
}

/// A frame with a 29-bit id and the bytes in hexadecimal.
inline hal::CanFrame frame(std::uint32_t id, std::string_view data) {
  hal::CanFrame result{.id = id, .extended = true};
  const Bytes bytes = hex(data);
  result.length = static_cast<std::uint8_t>(bytes.size());
  std::ranges::copy(bytes, result.data.begin());
  return result;
}

}  // namespace protocol::testing
