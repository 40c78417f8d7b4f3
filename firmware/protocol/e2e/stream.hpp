#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

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

/// The CRC of Profile 22 over all bytes but its own, and the data id after them (AUTOSAR FO PRS E2E
/// Protocol, Profile 22, calculation of the CRC). Precondition: crc_byte < data.size().
constexpr std::uint8_t crc_over(std::span<const std::byte> data, std::size_t crc_byte,
                                std::uint8_t data_id) {
  Crc8h2f crc;
  for (std::size_t i = 0; i < data.size(); ++i) {
    if (i != crc_byte) {
      crc.add(std::to_integer<std::uint8_t>(data[i]));
    }
  }
  crc.add(data_id);
  return crc.value();
}

/// The CRC that the frame ought to have. Precondition: it has the length of the stream's frames.
constexpr std::uint8_t crc_of(const Stream& stream, const hal::CanFrame& frame) {
  return crc_over(frame.payload(), stream.crc_byte, stream.data_ids.at(counter_of(stream, frame)));
}

}  // namespace protocol::e2e
