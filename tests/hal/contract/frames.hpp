#pragma once

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

#include "hal/can_frame.hpp"

namespace hal {

/// For messages of failed tests: id, extended or not, bytes.
inline void PrintTo(const CanFrame& frame, std::ostream* out) {
  *out << std::hex << frame.id << (frame.extended ? "x" : "") << std::dec << '['
       << unsigned{frame.length} << ']';
  for (const std::byte byte : frame.data) {
    *out << ' ' << static_cast<unsigned>(byte);
  }
}

}  // namespace hal

namespace hal_test {

/// A frame whose bytes are first, first + 1, ...
inline hal::CanFrame frame(std::uint32_t id, std::uint8_t length, std::uint8_t first,
                           bool extended = false) {
  hal::CanFrame result{.id = id, .extended = extended, .length = length, .data = {}};
  for (std::size_t i = 0; i < length; ++i) {
    result.data[i] = static_cast<std::byte>(first + i);
  }
  return result;
}

/// Every length, both kinds of id and their ends.
inline std::vector<hal::CanFrame> all_shapes() {
  std::vector<hal::CanFrame> frames;
  for (std::uint8_t length = 0; length <= 8; ++length) {
    frames.push_back(frame(0x180u + length, length, static_cast<std::uint8_t>(16 * length)));
  }
  frames.push_back(frame(0, 1, 0xff));
  frames.push_back(frame(0x7ff, 8, 0x80));
  frames.push_back(frame(0x18daf101, 8, 0x21, true));
  frames.push_back(frame(0x1fffffff, 3, 0x01, true));
  frames.push_back(frame(0x1, 0, 0, true));
  return frames;
}

}  // namespace hal_test
