#pragma once

#include <cstdint>

#include "firmware/protocol/e2e/stream.hpp"

namespace protocol::e2e {

/// The sender's side of Profile 22, one for each kind of frame and node. Counts from 0.
///
///   Protector protector(stream_of<LifeStatus>(node));
///   hal::CanFrame frame = encode(node, status);
///   protector.protect(frame);
class Protector {
 public:
  constexpr explicit Protector(const Stream& stream) : stream_(stream) {}

  /// Puts counter and CRC into a frame of the stream.
  constexpr void protect(hal::CanFrame& frame) {
    std::byte& counter = frame.data[stream_.crc_byte + 1u];
    counter = (counter & std::byte{0xf0}) | std::byte{counter_};
    frame.data[stream_.crc_byte] = std::byte{crc_of(stream_, frame)};
    counter_ = (counter_ + 1) & 0x0f;
  }

  /// The frame protected last did not leave: the next one has its counter, so that receivers see no
  /// loss.
  constexpr void withdraw() { counter_ = (counter_ - 1) & 0x0f; }

 private:
  Stream stream_;
  std::uint8_t counter_ = 0;
};

}  // namespace protocol::e2e
