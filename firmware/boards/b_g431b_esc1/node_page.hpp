#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "firmware/app/config.hpp"
#include "lifemodel/support/bytes.hpp"

namespace boards::b_g431b_esc1 {

/// Settings of one node, written once with the firmware by make_node_page.py: little-endian words
/// magic "TLND", version 1, node id 1 .. 127 with bit 8 set where the termination stays open, then
/// 16 bytes of key, then the CRC-32 of all before.
inline constexpr std::uint32_t kNodeMagic = 0x444E4C54;
inline constexpr std::uint32_t kNodeVersion = 1;
inline constexpr std::size_t kNodeBytes = 32;
inline constexpr std::uint32_t kOpenTermination = 0x100;

struct NodeSettings {
  protocol::Node node;
  app::Key key;
  bool terminated;  ///< closes the 120 ohm of the bus
  bool whole;       ///< false: there was no page, or it is damaged
};

/// Nothing where it is not whole.
constexpr std::optional<NodeSettings> decode_node(std::span<const std::byte, kNodeBytes> bytes) {
  lifemodel::ByteReader in(bytes);
  const bool known = in.u32() == kNodeMagic && in.u32() == kNodeVersion;
  const std::uint32_t word = in.u32();
  const std::uint32_t node = word & ~kOpenTermination;
  if (!known || node < 1 || node > 127 ||
      lifemodel::crc32(bytes.first<kNodeBytes - 4>()) !=
          lifemodel::ByteReader(bytes.last<4>()).u32()) {
    return std::nullopt;
  }
  NodeSettings settings{
      static_cast<protocol::Node>(node), {}, (word & kOpenTermination) == 0, true};
  std::copy_n(bytes.begin() + 12, settings.key.size(), settings.key.begin());
  return settings;
}

/// What a board without settings is: the last node id, terminated, and nobody has authority.
inline constexpr NodeSettings kNoSettings{127, {}, true, false};

}  // namespace boards::b_g431b_esc1
