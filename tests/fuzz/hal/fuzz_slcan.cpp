// Any bytes from the host, in any pieces, to a node that sends now and then over a line that
// stalls. Invariants: only frames that can be on a bus come out, each came from a line that reads
// the same; what the node says is whole lines; the same bytes in other pieces lead to the same
// frames.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hal/slcan/port.hpp"

namespace {

using hal::CanFrame;
using hal::slcan::Port;

void require(bool holds, const char* what) {
  if (!holds) {
    std::fprintf(stderr, "does not hold: %s\n", what);
    std::abort();
  }
}

struct Wire {
  std::span<const std::uint8_t> to_node;
  std::string to_host;
  std::size_t room = 1'000'000;

  std::size_t try_read(std::span<std::byte> out) {
    const std::size_t count = std::min(out.size(), to_node.size());
    std::ranges::copy(std::as_bytes(to_node.first(count)), out.begin());
    to_node = to_node.subspan(count);
    return count;
  }
  std::size_t try_write(std::span<const std::byte> in) {
    const std::size_t count = std::min(in.size(), room);
    to_host.append(reinterpret_cast<const char*>(in.data()), count);
    room -= count;
    return count;
  }
};

void check_frame(const CanFrame& frame) {
  require(frame.length <= 8, "at most 8 bytes");
  require(frame.id <= (frame.extended ? 0x1fff'ffffu : 0x7ffu), "an id in its range");
  for (std::size_t i = frame.length; i < frame.data.size(); ++i) {
    require(frame.data[i] == std::byte{}, "zeros past the length");
  }
  const auto text = hal::slcan::format({frame, false});
  const auto read = hal::slcan::parse_frame(text.view().substr(0, text.view().size() - 1));
  require(read.has_value() && read->frame == frame, "a frame is read back");
}

void drain(Port<Wire>& port, Wire& wire, std::vector<CanFrame>& frames) {
  for (bool more = true; more;) {
    const std::size_t before = wire.to_node.size();
    const auto frame = port.receive();
    if (frame) {
      check_frame(*frame);
      frames.push_back(*frame);
    }
    more = wire.to_node.size() != before;
  }
}

std::vector<CanFrame> in_one_piece(std::span<const std::uint8_t> bytes) {
  Wire wire{bytes, {}};
  Port<Wire> port(wire, hal::slcan::Channel::open);
  std::vector<CanFrame> frames;
  drain(port, wire, frames);
  return frames;
}

/// Every piece as long as its first byte says, which is part of the text.
std::vector<CanFrame> in_pieces(std::span<const std::uint8_t> bytes) {
  Wire wire;
  Port<Wire> port(wire, hal::slcan::Channel::open);
  std::vector<CanFrame> frames;
  std::size_t said = 0;
  while (!bytes.empty()) {
    const std::size_t size = std::min<std::size_t>(bytes.size(), 1 + bytes.front() % 40);
    wire.to_node = bytes.first(size);
    wire.room = bytes.front() * 2u;
    bytes = bytes.subspan(size);
    drain(port, wire, frames);
    // What the node sends must not tear its answers.
    if (port.send({0x181, false, 1, {std::byte{0x42}}}) == hal::Error::none) {
      ++said;
    }
    wire.room = 1'000'000;
    drain(port, wire, frames);
    require(wire.to_node.empty(), "a host that reads is read");
  }
  std::size_t seen = 0;
  std::string_view left = wire.to_host;
  while (!left.empty()) {
    const std::size_t end = left.find_first_of("\r\a");
    require(end != std::string_view::npos, "answers end");
    seen += left.substr(0, end) == "t181142" ? 1 : 0;
    require(end <= hal::slcan::kLongestLine, "answers are lines");
    left.remove_prefix(end + 1);
  }
  require(seen == said, "every frame that was taken is said, once and whole");
  return frames;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::span bytes(data, size);
  require(in_one_piece(bytes) == in_pieces(bytes), "pieces make no difference");
  return 0;
}
