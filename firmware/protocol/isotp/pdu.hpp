#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "firmware/protocol/messages.hpp"
#include "hal/can_frame.hpp"
#include "hal/clock.hpp"

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

enum class PduType : std::uint8_t { single, first, consecutive, flow_control };

/// FlowStatus (ISO 15765-2, 9.6.5.2).
enum class FlowStatus : std::uint8_t { continue_to_send = 0, wait = 1, overflow = 2, invalid };

inline constexpr std::size_t kSingleBytes = 7;       ///< that a single frame carries at most
inline constexpr std::size_t kFirstBytes = 6;        ///< that a first frame carries
inline constexpr std::size_t kConsecutiveBytes = 7;  ///< that a consecutive frame carries at most
inline constexpr std::uint32_t kMostBytes = 4095;    ///< of a message, without the long form

/// One frame of the transport protocol (ISO 15765-2, 9.6). What its type does not have is zero.
struct Pdu {
  PduType type = PduType::single;
  std::uint32_t length = 0;   ///< of the message
  std::uint8_t sequence = 0;  ///< 0 .. 15
  FlowStatus status = FlowStatus::continue_to_send;
  std::uint8_t block_size = 0;
  std::uint8_t st_min = 0;
  std::span<const std::byte> data{};  ///< in the frame that was read
};

namespace detail {

constexpr std::optional<Pdu> read_single(std::span<const std::byte> bytes) {
  const auto length = static_cast<std::size_t>(bytes[0] & std::byte{0x0f});
  if (length == 0 || length >= bytes.size()) {
    return std::nullopt;
  }
  return Pdu{.type = PduType::single,
             .length = static_cast<std::uint32_t>(length),
             .data = bytes.subspan(1, length)};
}

constexpr std::optional<Pdu> read_first(std::span<const std::byte> bytes) {
  if (bytes.size() != 8) {
    return std::nullopt;
  }
  const auto byte = [bytes](std::size_t i) { return static_cast<std::uint32_t>(bytes[i]); };
  const std::uint32_t length = ((byte(0) & 0x0fu) << 8) | byte(1);
  if (length > kSingleBytes) {
    return Pdu{.type = PduType::first, .length = length, .data = bytes.subspan(2)};
  }
  const std::uint32_t long_length = (byte(2) << 24) | (byte(3) << 16) | (byte(4) << 8) | byte(5);
  if (length != 0 || long_length <= kMostBytes) {
    return std::nullopt;
  }
  return Pdu{.type = PduType::first, .length = long_length, .data = bytes.subspan(6)};
}

constexpr std::optional<Pdu> read_flow_control(std::span<const std::byte> bytes) {
  if (bytes.size() < 3) {
    return std::nullopt;
  }
  const auto status = static_cast<std::uint8_t>(bytes[0] & std::byte{0x0f});
  constexpr auto kInvalid = static_cast<std::uint8_t>(FlowStatus::invalid);
  return Pdu{.type = PduType::flow_control,
             .status = static_cast<FlowStatus>(status < kInvalid ? status : kInvalid),
             .block_size = static_cast<std::uint8_t>(bytes[1]),
             .st_min = static_cast<std::uint8_t>(bytes[2])};
}

}  // namespace detail

/// The number behind a sequence number.
constexpr std::uint8_t following(std::uint8_t sequence) {
  return static_cast<std::uint8_t>((sequence + 1) % 16);
}

/// Reads a frame with any padding; nothing where type, length and size contradict each other
/// (ISO 15765-2, 9.6.2.2, 9.6.3.2).
constexpr std::optional<Pdu> read(const hal::CanFrame& frame) {
  const auto bytes = frame.payload();
  if (bytes.empty()) {
    return std::nullopt;
  }
  switch (static_cast<std::uint8_t>(bytes[0] >> 4)) {
    case 0:
      return detail::read_single(bytes);
    case 1:
      return detail::read_first(bytes);
    case 2:
      if (bytes.size() < 2) {
        return std::nullopt;
      }
      return Pdu{.type = PduType::consecutive,
                 .sequence = static_cast<std::uint8_t>(bytes[0] & std::byte{0x0f}),
                 .data = bytes.subspan(1)};
    case 3:
      return detail::read_flow_control(bytes);
    default:
      return std::nullopt;
  }
}

/// A frame without padding, which would only load the bus: control bytes, then data.
/// @pre at most 8 bytes
template <std::size_t kControlBytes>
constexpr hal::CanFrame make_frame(std::uint32_t id, const std::uint8_t (&control)[kControlBytes],
                                   std::span<const std::byte> data) {
  hal::CanFrame frame{.id = id, .extended = true};
  for (const std::uint8_t byte : control) {
    frame.data[frame.length++] = std::byte{byte};
  }
  for (const std::byte byte : data) {
    frame.data[frame.length++] = byte;
  }
  return frame;
}

/// STmin of a flow control frame (ISO 15765-2, 9.6.5.5): 0x00 .. 0x7f ms, 0xf1 .. 0xf9 for
/// 100 .. 900 us. Reserved values count as the longest.
constexpr hal::Time separation(std::uint8_t st_min) {
  if (st_min >= 0xf1 && st_min <= 0xf9) {
    return hal::microseconds(100 * std::uint64_t{st_min - 0xf0u});
  }
  return hal::milliseconds(st_min <= 0x7f ? st_min : 0x7fu);
}

/// What a receiver asks of its sender.
///
/// One flow control for a whole message: each of them is a frame of ours. 5 ms between frames hold
/// a sender to 32 kbit/s and suit a receiver that looks once in that time.
struct Pace {
  std::uint8_t block_size = 0;  ///< consecutive frames for each flow control; 0: all
  std::uint8_t st_min = 5;      ///< see separation()
};

/// Limits of ISO 15765-2, 9.8.
inline constexpr hal::Time kFlowControlTimeout = hal::milliseconds(1000);  ///< N_Bs
inline constexpr hal::Time kConsecutiveTimeout = hal::milliseconds(1000);  ///< N_Cr
inline constexpr std::uint8_t kMostWaits = 10;  ///< flow controls in a row that say wait

/// The longest that a frame of 8 bytes takes: 160 bits at 500 kbit/s. A gap counts from the end of
/// a frame, and the sender only knows when it handed the frame over.
inline constexpr hal::Time kFrameTime = hal::microseconds(320);

/// What a link has seen since its start. Each stops at 2^32 - 1.
struct Counts {
  std::uint32_t received = 0;         ///< whole messages
  std::uint32_t sent = 0;             ///< whole messages, as far as the sender knows
  std::uint32_t malformed = 0;        ///< frames whose type, length and size contradict each other
  std::uint32_t unexpected = 0;       ///< frames that nothing had asked for
  std::uint32_t oversized = 0;        ///< messages too long for this link
  std::uint32_t not_taken = 0;        ///< messages that came while the last one was still here
  std::uint32_t interrupted = 0;      ///< messages cut off by the next one
  std::uint32_t wrong_sequence = 0;   ///< messages with a consecutive frame missing or twice
  std::uint32_t receive_timeout = 0;  ///< messages whose rest did not come (N_Cr)
  std::uint32_t send_timeout = 0;     ///< messages for which no flow control came (N_Bs)
  std::uint32_t send_refused = 0;  ///< messages that the receiver refused, or made wait too often

  friend constexpr bool operator==(const Counts&, const Counts&) = default;
};

constexpr void count(std::uint32_t& counter) {
  if (counter + 1 != 0) {
    ++counter;
  }
}

}  // namespace protocol::isotp
