#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>

#include "hal/can_frame.hpp"

namespace protocol::test {

/// A frame with these bytes.
constexpr hal::CanFrame frame(std::uint32_t id, std::initializer_list<std::uint8_t> bytes) {
  hal::CanFrame made{.id = id, .length = static_cast<std::uint8_t>(bytes.size())};
  std::size_t at = 0;
  for (const std::uint8_t byte : bytes) {
    made.data[at++] = std::byte{byte};
  }
  return made;
}

/// The same with one bit of its payload turned over.
constexpr hal::CanFrame flipped(hal::CanFrame frame, std::size_t bit) {
  frame.data[bit / 8] ^= std::byte{1} << (bit % 8);
  return frame;
}

}  // namespace protocol::test
