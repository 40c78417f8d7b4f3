#pragma once

#include <cstdint>

#include "hal/clock.hpp"

namespace protocol::isotp {

/// STmin of a flow control frame (ISO 15765-2, 9.6.5.5): 0x00 .. 0x7f ms, 0xf1 .. 0xf9 for
/// 100 .. 900 us. Reserved values count as the longest.
constexpr hal::Time separation(std::uint8_t st_min) {
  if (st_min >= 0xf1 && st_min <= 0xf9) {
    return hal::microseconds(100 * std::uint64_t{st_min - 0xf0u});
  }
  return hal::milliseconds(st_min <= 0x7f ? st_min : 0x7fu);
}

}  // namespace protocol::isotp
