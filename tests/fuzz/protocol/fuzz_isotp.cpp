// Any stream of frames, sends and pauses at a link; then the link still brings a message.
//
// Input: one step after another, each with a byte first:
//   1.tsllll  a frame is asked for; t: what was received is taken; s: 1 + 2 l bytes are sent
//   01pppppp  a pause of 20 p ms
//   00..llll  a frame of l bytes arrives; they follow
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "firmware/protocol/isotp/link.hpp"

namespace {

using protocol::isotp::Address;

constexpr std::size_t kMost = 40;
using Link = protocol::isotp::Link<kMost>;

void require(bool holds) {
  if (!holds) {
    std::abort();
  }
}

hal::CanFrame next_frame(std::span<const std::uint8_t>& data) {
  hal::CanFrame frame{.id = Address::to_node(5).id(), .extended = true};
  const std::size_t length = data[0] & 0x0fu;
  data = data.subspan(1);
  while (frame.length < length && frame.length < 8 && !data.empty()) {
    frame.data[frame.length++] = std::byte{data[0]};
    data = data.subspan(1);
  }
  return frame;
}

void require_wellformed(const hal::CanFrame& frame) {
  require(frame.id == Address::to_tester(5).id() && frame.extended);
  require(frame.length >= 2 && frame.length <= 8);
  require(protocol::isotp::read(frame).has_value());
  for (std::size_t i = frame.length; i < frame.data.size(); ++i) {
    require(frame.data[i] == std::byte{0});
  }
}

void require_usable(Link& link, hal::Time now) {
  // Every timeout is over, and what was left to send leaves.
  for (int i = 0; i < 40; ++i) {
    now = now + hal::seconds(2);
    if (const auto frame = link.next_frame(now)) {
      require_wellformed(*frame);
    }
  }
  require(!link.sending());
  link.clear();
  Link tester(Address::to_node(5));
  std::array<std::byte, kMost> message{};
  for (std::size_t i = 0; i < message.size(); ++i) {
    message[i] = static_cast<std::byte>(i + 1);
  }
  require(tester.send(message) == hal::Error::none);
  while (tester.sending()) {
    now = now + hal::milliseconds(10);
    if (const auto frame = tester.next_frame(now)) {
      link.on_frame(*frame, now);
    }
    if (const auto frame = link.next_frame(now)) {
      tester.on_frame(*frame, now);
    }
  }
  const auto received = link.received();
  require(received.size() == message.size());
  for (std::size_t i = 0; i < message.size(); ++i) {
    require(received[i] == message[i]);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  std::span data(bytes, size);
  hal::Time now{};
  Link link(Address::to_tester(5), {.block_size = static_cast<std::uint8_t>(size % 4)});
  while (!data.empty()) {
    const std::uint8_t step = data[0];
    if ((step & 0x80) != 0) {
      data = data.subspan(1);
      if (const auto frame = link.next_frame(now)) {
        require_wellformed(*frame);
      }
      require(link.received().size() <= kMost);
      if ((step & 0x20) != 0) {
        link.clear();
      }
      if ((step & 0x10) != 0 && !link.sending()) {
        const std::array<std::byte, kMost> message{};
        const std::size_t length = 1 + (step & 0x0fu) * 2u;
        require(link.send(std::span(message).first(length)) == hal::Error::none);
      }
    } else if ((step & 0x40) != 0) {
      data = data.subspan(1);
      now = now + hal::milliseconds((step & 0x3fu) * 20u);
    } else {
      link.on_frame(next_frame(data), now);
    }
  }
  require_usable(link, now);
  return 0;
}
