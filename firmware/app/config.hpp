#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "firmware/protocol/messages.hpp"

namespace app {

/// AES-128 key of this node. All zero: nothing that needs authority is allowed.
using Key = std::array<std::byte, 16>;

/// Version of the firmware, major in the high 4 bits, minor in the low.
inline constexpr std::uint8_t kFirmwareVersion = 0x01;

struct Config {
  protocol::Node node = 1;
  Key key{};
  std::array<std::byte, 12> serial{};  ///< of the controller; shorter ones end in zeros
  bool whole = true;  ///< false: where these are kept there was nothing that is whole
};

}  // namespace app
