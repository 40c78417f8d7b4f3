#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "firmware/protocol/schema/signal.hpp"

namespace protocol::schema {

enum class Sender : std::uint8_t { node, host };

/// Where the header of AUTOSAR E2E Profile 22 lies: the CRC, and in the low half of the byte after
/// it the counter.
struct Integrity {
  std::uint8_t crc_byte = 0;
  std::uint8_t id_list = 0;  ///< 0 .. 3, see e2e/data_id.hpp; each protected frame has its own
};

/// One frame of the plan, with the node id left out of its identifier (CiA 301, 7.3.3).
struct Frame {
  std::string_view name = {};
  std::uint16_t base_id = 0;   ///< identifier without node; the node takes its low 7 bits
  std::uint8_t length = 0;     ///< bytes, always all of them
  std::uint16_t cycle_ms = 0;  ///< longest time between two frames; 0 where it is not cyclic
  Sender sender = Sender::node;
  std::string_view sent = {};  ///< when, in words
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

}  // namespace protocol::schema
