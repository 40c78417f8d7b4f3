#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <tuple>
#include <type_traits>

namespace protocol::schema {

/// What a raw value of a signal stands for.
struct ValueName {
  std::uint32_t value = 0;
  std::string_view name;  ///< [a-z0-9_]
};

/// An unsigned number in a frame, little-endian. Texts are ASCII on one line, without double
/// quotes, semicolons and backslashes, so that every reader of a DBC file takes them.
struct Signal {
  std::string_view name;          ///< unique in its frame; a letter, then letters and digits
  std::uint8_t start_bit = 0;     ///< of its lowest bit; bit 0 is the lowest of byte 0
  std::uint8_t bits = 0;          ///< 1 .. 32
  std::string_view factor = "1";  ///< physical value of one step, a decimal without exponent
  std::string_view unit = {};     ///< of the physical value; empty where it has none
  std::string_view comment = {};  ///< what it means
  std::span<const ValueName> values = {};
  bool stops = false;      ///< what is larger is sent as the largest value, which means "or more"
  bool is_closed = false;  ///< only named values may appear; set by field() from the member's type
};

/// The largest raw value that `bits` hold.
constexpr std::uint32_t largest(std::uint8_t bits) {
  return bits >= 32 ? 0xffff'ffffu : (std::uint32_t{1} << bits) - 1;
}

/// Whether a raw value stands for itself or more: the end of a range that stops, or, where that has
/// a name, the value before it.
constexpr bool is_at_least(const Signal& signal, std::uint32_t raw) {
  std::uint32_t end = largest(signal.bits);
  for (const ValueName& value : signal.values) {
    end -= value.value == largest(signal.bits) ? 1u : 0u;
  }
  return signal.stops && raw == end;
}

/// The bits of a payload that the signal takes, byte 0 lowest.
constexpr std::uint64_t mask_of(const Signal& signal) {
  return std::uint64_t{largest(signal.bits)} << signal.start_bit;
}

enum class Sender : std::uint8_t { node, host };

/// Where the header of AUTOSAR E2E Profile 22 lies: the CRC, and in the low half of the byte after
/// it the counter.
struct Integrity {
  std::uint8_t crc_byte = 0;
  std::uint8_t id_list = 0;  ///< 0 .. 3, see e2e::DataIds; each protected frame has its own
};

/// One frame of the plan, with the node id left out of its identifier (CiA 301, 7.3.3).
struct Frame {
  std::string_view name = {};
  std::uint16_t base_id = 0;   ///< identifier without node; the node takes its low 7 bits
  std::uint8_t length = 0;     ///< bytes, always all of them
  std::uint16_t cycle_ms = 0;  ///< longest time between two frames; 0 where it is not cyclic
  Sender sender = Sender::node;
  std::string_view sent = {};  ///< when, as prose
  std::string_view comment = {};
  std::optional<Integrity> integrity = {};
  std::optional<Signal> page = {};  ///< the multiplexor, where the frame has pages
};

/// The CRC as a signal.
constexpr Signal crc_signal(const Integrity& integrity) {
  return {.name = "Crc",
          .start_bit = static_cast<std::uint8_t>(8 * integrity.crc_byte),
          .bits = 8,
          .comment = "CRC-8H2F over the other bytes and the data id (AUTOSAR E2E Profile 22)"};
}

/// The counter as a signal.
constexpr Signal counter_signal(const Integrity& integrity) {
  return {.name = "Counter",
          .start_bit = static_cast<std::uint8_t>(8 * (integrity.crc_byte + 1)),
          .bits = 4,
          .comment = "counts the frames of this kind, 15 is followed by 0"};
}

/// The bits of a payload that belong to the frame and not to a message in it.
constexpr std::uint64_t header_mask(const Frame& frame) {
  std::uint64_t mask = 0;
  if (frame.integrity) {
    mask |= mask_of(crc_signal(*frame.integrity)) | mask_of(counter_signal(*frame.integrity));
  }
  if (frame.page) {
    mask |= mask_of(*frame.page);
  }
  return mask;
}

/// The bits of a payload of `length` bytes.
constexpr std::uint64_t payload_mask(std::uint8_t length) {
  return length >= 8 ? ~std::uint64_t{0} : (std::uint64_t{1} << (8 * length)) - 1;
}

/// A member of a message and the signal that carries it.
template <class Message, class Member>
struct Field {
  Member Message::*member;
  Signal signal;
};

/// Values of an enumeration are closed: receivers refuse those without a name.
template <class Message, class Member>
consteval Field<Message, Member> field(Member Message::*member, Signal signal) {
  signal.is_closed = std::is_enum_v<Member>;
  return {member, signal};
}

/// How a message lies in its frame. Specialised for each message with
///   kFrame    the Frame
///   kName     of the message: the frame's, or the page's
///   kComment  of the page; empty where there are no pages
///   kFields   a tuple of Field, one for each member
template <class Message>
struct Layout;

template <class Message>
inline constexpr std::size_t kFieldCount = std::tuple_size_v<decltype(Layout<Message>::kFields)>;

/// The signal of a member.
template <class Message, class Member>
constexpr Signal signal_of(Member Message::*member) {
  Signal found;
  std::apply(
      [&](const auto&... fields) {
        const auto look_at = [&]<class Other>(const Field<Message, Other>& field) {
          if constexpr (std::is_same_v<Member, Other>) {
            found = field.member == member ? field.signal : found;
          }
        };
        (look_at(fields), ...);
      },
      Layout<Message>::kFields);
  return found;
}

/// Whether the message is a page of its frame.
template <class Message>
inline constexpr bool kIsPage = requires {
  Message::kPage;
};

}  // namespace protocol::schema
