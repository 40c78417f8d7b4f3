#pragma once

#include <cstddef>
#include <cstdint>

#include "firmware/protocol/codec/address.hpp"
#include "firmware/protocol/e2e/crc8h2f.hpp"
#include "firmware/protocol/e2e/data_id.hpp"
#include "firmware/protocol/schema/layout.hpp"
#include "hal/can_frame.hpp"

namespace protocol::e2e {

/// All frames of one kind of one node: what their protection depends on.
struct Stream {
  std::uint32_t id = 0;
  std::uint8_t length = 0;
  std::uint8_t crc_byte = 0;
  DataIds data_ids;
};

/// Precondition: the frame is protected.
constexpr Stream stream_of(const schema::Frame& frame, Node node) {
  return {.id = id_of(frame, node),
          .length = frame.length,
          .crc_byte = frame.integrity->crc_byte,
          .data_ids = DataIds(frame.integrity->id_list, node)};
}
template <class Message>
requires(schema::Layout<Message>::kFrame.integrity.has_value()) constexpr Stream
    stream_of(Node node) {
  return stream_of(schema::Layout<Message>::kFrame, node);
}

/// The counter in the frame.
constexpr std::uint8_t counter_of(const Stream& stream, const hal::CanFrame& frame) {
  return std::to_integer<std::uint8_t>(frame.data[stream.crc_byte + 1u]) & 0x0f;
}

/// The CRC that the frame ought to have: over all bytes but its own, and the data id of its counter
/// (AUTOSAR FO PRS E2E Protocol, 6.13).
constexpr std::uint8_t crc_of(const Stream& stream, const hal::CanFrame& frame) {
  Crc8h2f crc;
  for (std::size_t i = 0; i < stream.length; ++i) {
    if (i != stream.crc_byte) {
      crc.add(std::to_integer<std::uint8_t>(frame.data[i]));
    }
  }
  crc.add(stream.data_ids.at(counter_of(stream, frame)));
  return crc.value();
}

}  // namespace protocol::e2e
