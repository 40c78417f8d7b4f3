#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "firmware/protocol/authority/cmac.hpp"
#include "firmware/protocol/messages.hpp"

namespace protocol::authority {

using Nonce = std::array<std::byte, 16>;

inline constexpr std::size_t kMacBytes = 8;
using Mac = std::array<std::byte, kMacBytes>;

/// What a client asks for under authority.
struct Command {
  std::uint16_t routine = 0;
  std::span<const std::byte> arguments;  ///< 0 .. 255 bytes
  std::uint32_t storage_counter = 0;     ///< as the client read it
};

/// The code that proves a command: AES-CMAC, cut to its first 8 bytes, over
///
///   0  4  "TLA1", so that the key proves nothing else
///   4  1  node
///   5  2  routine, the high byte first, as in the request
///   7  1  length of the arguments
///   8 16  nonce, as the node issued it
///  24  4  storage counter, little-endian
///  28  .  arguments, as in the request
constexpr Mac mac(const Key& key, Node node, const Command& command, const Nonce& nonce) {
  Cmac cmac(key);
  for (const char letter : {'T', 'L', 'A', '1'}) {
    cmac.add(static_cast<std::byte>(letter));
  }
  cmac.add(std::byte{node});
  cmac.add(static_cast<std::byte>(command.routine >> 8));
  cmac.add(static_cast<std::byte>(command.routine));
  cmac.add(static_cast<std::byte>(command.arguments.size()));
  cmac.add(nonce);
  for (int shift = 0; shift < 32; shift += 8) {
    cmac.add(static_cast<std::byte>(command.storage_counter >> shift));
  }
  cmac.add(command.arguments);
  const Block whole = cmac.finish();
  Mac result{};
  std::copy_n(whole.begin(), result.size(), result.begin());
  return result;
}

}  // namespace protocol::authority
