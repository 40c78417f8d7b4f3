#pragma once

#include <cstdint>
#include <optional>

#include "firmware/protocol/messages.hpp"
#include "firmware/protocol/schema/layout.hpp"
#include "hal/can_frame.hpp"

namespace protocol {

inline constexpr std::uint32_t kNodeMask = 0x7f;

/// The identifier of a frame of this node, 11 bits.
constexpr std::uint32_t id_of(const schema::Frame& frame, Node node) {
  return frame.base_id | (node & kNodeMask);
}
template <class Message>
constexpr std::uint32_t id_of(Node node) {
  return id_of(schema::Layout<Message>::kFrame, node);
}

/// The node whose frame it is, or nothing where it is another frame or that of no node.
constexpr std::optional<Node> node_of(const schema::Frame& frame, const hal::CanFrame& received) {
  const auto node = static_cast<Node>(received.id & kNodeMask);
  if (received.extended || node == 0 || received.id != id_of(frame, node)) {
    return std::nullopt;
  }
  return node;
}
template <class Message>
constexpr std::optional<Node> node_of(const hal::CanFrame& received) {
  return node_of(schema::Layout<Message>::kFrame, received);
}

}  // namespace protocol
