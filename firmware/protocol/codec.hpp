#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>

#include "firmware/protocol/codec/address.hpp"
#include "firmware/protocol/codec/decode_error.hpp"
#include "firmware/protocol/codec/field_codec.hpp"
#include "firmware/protocol/codec/payload.hpp"
#include "firmware/protocol/messages.hpp"
#include "firmware/protocol/schema/checks.hpp"
#include "firmware/protocol/schema/plan.hpp"
#include "hal/can_frame.hpp"
#include "lifemodel/support/result.hpp"

/// Messages to frames and back, after the plan in schema/plan.hpp: Heartbeat, LifeStatus, each of
/// detail::*, Emergency and Command.
namespace protocol {

template <class Message>
using Decoded = lifemodel::Result<Message, DecodeError>;

namespace codec_detail {

template <class Message>
using Fields = std::make_index_sequence<schema::kFieldCount<Message>>;

template <class Message>
constexpr std::uint64_t page_bits() {
  if constexpr (schema::kIsPage<Message>) {
    return std::uint64_t{Message::kPage} << schema::Layout<Message>::kFrame.page->start_bit;
  } else {
    return 0;
  }
}

template <class Message>
constexpr std::uint64_t page_mask() {
  if constexpr (schema::kIsPage<Message>) {
    return schema::mask_of(*schema::Layout<Message>::kFrame.page);
  } else {
    return 0;
  }
}

/// The bits of a payload that mean something.
template <class Message>
constexpr std::uint64_t known_mask() {
  std::uint64_t mask = schema::header_mask(schema::Layout<Message>::kFrame);
  for (const schema::Signal& signal : schema::kSignals<Message>) {
    mask |= schema::mask_of(signal);
  }
  return mask;
}

template <class Message, std::size_t... kIndices>
constexpr std::uint64_t put(const Message& message, std::index_sequence<kIndices...>) {
  return (std::uint64_t{0} | ... | FieldCodec<Message, kIndices>::put(message));
}

template <class Message, std::size_t... kIndices>
constexpr bool get(std::uint64_t word, Message& message, std::index_sequence<kIndices...>) {
  return (FieldCodec<Message, kIndices>::get(word, message) && ...);
}

}  // namespace codec_detail

/// The frame that carries `message` of `node`, 1 .. 127. Values wider than their field stop at its
/// largest. CRC and counter are zero until an e2e::Protector has been over it.
template <class Message>
[[nodiscard]] constexpr hal::CanFrame encode(Node node, const Message& message) {
  using namespace codec_detail;
  constexpr std::uint8_t kLength = schema::Layout<Message>::kFrame.length;
  constexpr std::uint64_t kPageBits = page_bits<Message>();
  return frame_of(id_of<Message>(node), kLength, kPageBits | put(message, Fields<Message>{}));
}

/// The message in `frame`, of whatever node. Says nothing of its CRC and counter: that is for an
/// e2e::Checker.
template <class Message>
[[nodiscard]] constexpr Decoded<Message> decode(const hal::CanFrame& frame) {
  using namespace codec_detail;
  constexpr std::uint8_t kLength = schema::Layout<Message>::kFrame.length;
  constexpr std::uint64_t kReserved = ~known_mask<Message>();
  if (!node_of<Message>(frame)) {
    return DecodeError::other_frame;
  }
  if (frame.length != kLength) {
    return DecodeError::wrong_length;
  }
  const std::uint64_t word = word_of(frame);
  if ((word & page_mask<Message>()) != page_bits<Message>()) {
    return DecodeError::other_page;
  }
  if ((word & kReserved) != 0) {
    return DecodeError::reserved_bit;
  }
  Message message;
  if (!get(word, message, Fields<Message>{})) {
    return DecodeError::reserved_value;
  }
  return message;
}

}  // namespace protocol
