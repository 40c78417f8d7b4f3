// Whatever the frame: each message is decoded to what encodes to the same bits, or refused.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "firmware/protocol/codec.hpp"

namespace {

using namespace protocol;

void require(bool holds) {
  if (!holds) {
    std::abort();
  }
}

/// Identifier, length and bytes, eleven in all; fewer are filled up with zeros.
hal::CanFrame frame_from(const std::uint8_t* data, std::size_t size) {
  hal::CanFrame frame;
  const auto at = [&](std::size_t i) { return i < size ? data[i] : std::uint8_t{0}; };
  frame.id = static_cast<std::uint32_t>(at(0) | ((at(1) & 0x0f) << 8));
  frame.extended = (at(1) & 0x10) != 0;
  frame.length = std::min<std::uint8_t>(at(2), 8);
  for (std::size_t i = 0; i < frame.length; ++i) {
    frame.data[i] = std::byte{at(3 + i)};
  }
  return frame;
}

std::uint64_t header_of(const schema::Frame& frame) {
  return frame.integrity ? schema::mask_of(schema::crc_signal(*frame.integrity)) |
                               schema::mask_of(schema::counter_signal(*frame.integrity))
                         : 0;
}

/// Returns whether the frame is this message.
template <class Message>
bool check(const hal::CanFrame& frame) {
  const auto decoded = decode<Message>(frame);
  if (!decoded) {
    return false;
  }
  const schema::Frame& kind = schema::Layout<Message>::kFrame;
  const auto node = node_of<Message>(frame);
  require(node && !frame.extended && frame.length == kind.length);
  const hal::CanFrame again = encode(*node, *decoded);
  require(again.id == frame.id && again.length == frame.length);
  require(word_of(again) == (word_of(frame) & ~header_of(kind)));
  require(*decode<Message>(again) == *decoded);
  return true;
}

template <class... Messages>
int how_many(const hal::CanFrame& frame, schema::MessageList<Messages...>) {
  return (0 + ... + (check<Messages>(frame) ? 1 : 0));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  require(how_many(frame_from(data, size), schema::AllMessages{}) <= 1);
  return 0;
}
