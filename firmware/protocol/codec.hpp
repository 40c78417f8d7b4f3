#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>

#include "firmware/protocol/messages.hpp"
#include "firmware/protocol/schema/frame.hpp"
#include "firmware/protocol/schema/plan.hpp"
#include "hal/can_frame.hpp"
#include "lifemodel/support/result.hpp"

/// Messages to frames and back, after the plan in schema/plan.hpp: Heartbeat, LifeStatus, each of
/// detail::*, Emergency and Command.
namespace protocol {

/// Why a frame is not the message that was asked for.
enum class [[nodiscard]] DecodeError : std::uint8_t{
    other_frame,     ///< another identifier, or that of no node
    wrong_length,    ///< not the number of bytes that the frame has
    other_page,      ///< another page of the frame
    reserved_bit,    ///< a bit is set that has no meaning
    reserved_value,  ///< a value that has no meaning
};

/// The payload as one little-endian number, byte 0 lowest.
constexpr std::uint64_t word_of(const hal::CanFrame& frame) {
  std::uint64_t word = 0;
  for (std::size_t i = frame.data.size(); i > 0; --i) {
    word = (word << 8) | static_cast<std::uint64_t>(frame.data[i - 1]);
  }
  return word;
}

/// A frame with an 11-bit identifier and such a payload.
/// @pre length <= 8, and `word` has no bits past it
constexpr hal::CanFrame frame_of(std::uint32_t id, std::uint8_t length, std::uint64_t word) {
  hal::CanFrame frame{.id = id, .length = length};
  for (std::byte& byte : frame.data) {
    byte = static_cast<std::byte>(word & 0xff);
    word >>= 8;
  }
  return frame;
}

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

/// Takes one member of a message to its bits and back. All about it but the value is known when it
/// is compiled, so that no text of the schema reaches the target.
template <class Message, std::size_t kIndex>
class FieldCodec {
 public:
  static constexpr const schema::Signal& kSignal =
      std::get<kIndex>(schema::Layout<Message>::kFields).signal;

  /// The bits in their place. A value that is too wide stops at the largest.
  static constexpr std::uint64_t put(const Message& message) {
    const auto raw = static_cast<std::uint32_t>(message.*kMember);
    constexpr std::uint32_t kLargest = schema::largest(kSignal.bits);
    return std::uint64_t{raw < kLargest ? raw : kLargest} << kSignal.start_bit;
  }

  /// False, and nothing has happened, where the value has no meaning.
  static constexpr bool get(std::uint64_t word, Message& message) {
    const auto raw =
        static_cast<std::uint32_t>(word >> kSignal.start_bit) & schema::largest(kSignal.bits);
    if (!has_meaning(raw)) {
      return false;
    }
    message.*kMember = static_cast<Member>(raw);
    return true;
  }

 private:
  static constexpr auto kMember = std::get<kIndex>(schema::Layout<Message>::kFields).member;
  using Member = std::remove_cvref_t<decltype(std::declval<Message&>().*kMember)>;
  static_assert(std::is_unsigned_v<Member> || std::is_enum_v<Member>);
  static_assert(sizeof(Member) * 8 >= kSignal.bits, "the member does not hold the signal");
  static_assert(!kSignal.is_closed || !kSignal.values.empty(), "its values have no names");

  static constexpr bool has_meaning(std::uint32_t raw) {
    if constexpr (kSignal.is_closed) {
      return [raw]<std::size_t... kValues>(std::index_sequence<kValues...>) {
        return ((raw == std::integral_constant<std::uint32_t, kSignal.values[kValues].value>{}) ||
                ...);
      }
      (std::make_index_sequence<kSignal.values.size()>{});
    } else {
      return true;
    }
  }
};

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
