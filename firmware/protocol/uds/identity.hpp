#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace protocol::uds {

/// Which device this is, and what runs on it.
struct Identity {
  std::array<std::byte, 12> serial{};  ///< of the controller; shorter ones end in zeros
  std::uint8_t schema = 0;             ///< version of the frame plan
  std::uint8_t firmware = 0;           ///< version, major in the high 4 bits, minor in the low
};

}  // namespace protocol::uds
