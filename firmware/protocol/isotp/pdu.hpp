#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "hal/can_frame.hpp"

namespace protocol::isotp {

enum class PduType : std::uint8_t { single, first, consecutive, flow_control };

/// FlowStatus (ISO 15765-2, 9.6.5.2).
enum class FlowStatus : std::uint8_t { go_on = 0, wait = 1, overflow = 2, invalid };

inline constexpr std::size_t kSingleBytes = 7;       ///< that a single frame carries at most
inline constexpr std::size_t kFirstBytes = 6;        ///< that a first frame carries
inline constexpr std::size_t kConsecutiveBytes = 7;  ///< that a consecutive frame carries at most
inline constexpr std::uint32_t kMostBytes = 4095;    ///< of a message, without the long form

/// One frame of the transport protocol (ISO 15765-2, 9.6). What its type does not have is zero.
struct Pdu {
  PduType type = PduType::single;
  std::uint32_t length = 0;   ///< of the message
  std::uint8_t sequence = 0;  ///< 0 .. 15
  FlowStatus status = FlowStatus::go_on;
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
/// Precondition: at most 8 bytes.
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

}  // namespace protocol::isotp
