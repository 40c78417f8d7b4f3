#pragma once

#include <cstddef>
#include <cstdint>

#include "hal/can_frame.hpp"

namespace protocol {

/// The payload as one little-endian number, byte 0 lowest.
constexpr std::uint64_t word_of(const hal::CanFrame& frame) {
  std::uint64_t word = 0;
  for (std::size_t i = frame.data.size(); i > 0; --i) {
    word = (word << 8) | static_cast<std::uint64_t>(frame.data[i - 1]);
  }
  return word;
}

/// A frame with an 11-bit identifier and such a payload. Precondition: length <= 8, and `word` has
/// no bits past it.
constexpr hal::CanFrame frame_of(std::uint32_t id, std::uint8_t length, std::uint64_t word) {
  hal::CanFrame frame{.id = id, .length = length};
  for (std::byte& byte : frame.data) {
    byte = static_cast<std::byte>(word & 0xff);
    word >>= 8;
  }
  return frame;
}

}  // namespace protocol
