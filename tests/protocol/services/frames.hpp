#pragma once

#include <algorithm>
#include <cstdint>
#include <string_view>

#include "hal/can_frame.hpp"
#include "tests/protocol/services/bytes.hpp"

namespace protocol::testing {

/// A frame with a 29-bit id and the bytes in hexadecimal.
inline hal::CanFrame frame(std::uint32_t id, std::string_view data) {
  hal::CanFrame result{.id = id, .extended = true};
  const Bytes bytes = hex(data);
  result.length = static_cast<std::uint8_t>(bytes.size());
  std::ranges::copy(bytes, result.data.begin());
  return result;
}

}  // namespace protocol::testing
