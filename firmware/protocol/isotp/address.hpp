#pragma once

#include <cstdint>
#include <optional>

#include "firmware/protocol/messages.hpp"
#include "hal/can_frame.hpp"

namespace protocol::isotp {

/// The tester's address on the bus.
inline constexpr std::uint8_t kTester = 0xf1;

/// Who sends and who is meant, in the 29-bit id of normal fixed addressing, physical: 0x18DA, the
/// target, the source (ISO 15765-2, 10.3.3.2).
struct Address {
  std::uint8_t target = 0;
  std::uint8_t source = 0;

  static constexpr Address to_node(Node node) { return {node, kTester}; }
  static constexpr Address to_tester(Node node) { return {kTester, node}; }

  /// Where the answer goes.
  [[nodiscard]] constexpr Address reversed() const { return {source, target}; }

  [[nodiscard]] constexpr std::uint32_t id() const {
    return kBase | (std::uint32_t{target} << 8) | source;
  }
  /// The address of a frame; nothing if it is none of these.
  static constexpr std::optional<Address> of(const hal::CanFrame& frame) {
    if (!frame.extended || (frame.id & ~0xffffu) != kBase) {
      return std::nullopt;
    }
    return Address{static_cast<std::uint8_t>(frame.id >> 8), static_cast<std::uint8_t>(frame.id)};
  }

  friend constexpr bool operator==(const Address&, const Address&) = default;

 private:
  static constexpr std::uint32_t kBase = 0x18DA'0000;
};

}  // namespace protocol::isotp
