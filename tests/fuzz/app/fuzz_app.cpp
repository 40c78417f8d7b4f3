#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

#include "tests/fuzz/app/input.hpp"
#include "tests/fuzz/app/node.hpp"

namespace {

using app::fuzz::Input;
using app::fuzz::Node;

hal::CanFrame frame(Input& in, std::uint32_t id, bool extended) {
  hal::CanFrame result{.id = id, .extended = extended, .length = 0, .data = {}};
  result.length = static_cast<std::uint8_t>(std::min(int{in.byte()}, 8));
  in.fill(std::span(result.data).first(result.length));
  return result;
}

/// One thing that happens on the bus, as the first byte says, or some time that passes.
void happen(Input& in, Node& node, std::uint32_t& left_ms) {
  switch (in.byte() % 6) {
    case 0:
      return node.hear(frame(in, 0x200u + app::fuzz::kNode, false));
    case 1:
      return node.hear(frame(in, 0x18da'00f1u + (std::uint32_t{app::fuzz::kNode} << 8), true));
    case 2: {
      const bool extended = in.byte() % 2 != 0;
      const std::uint32_t id = in.word() & (extended ? 0x1fff'ffffu : 0x7ffu);
      return node.hear(frame(in, id, extended));
    }
    case 3: {
      const auto code = static_cast<protocol::CommandCode>(in.byte());
      return node.hear_command({code, in.byte()});
    }
    case 4: {
      std::array<std::byte, protocol::uds::kMostMessageBytes> request{};
      const std::size_t size = 1 + in.byte() % request.size();
      in.fill(std::span(request).first(size));
      return node.hear_request(std::span(request).first(size));
    }
    default: {
      const std::uint32_t time_ms = std::min(1u + in.byte(), left_ms);
      left_ms -= time_ms;
      return node.pass_ms(time_ms, static_cast<std::int32_t>(in.byte()) << 22);
    }
  }
}

}  // namespace

/// A node hears what the input says.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::uint32_t left_ms = 3'000;
  Input in(data, size);
  const auto node = std::make_unique<Node>();
  while (!in.empty() && left_ms != 0) {
    happen(in, *node, left_ms);
  }
  node->pass_ms(10, 0);
  node->finish();
  return 0;
}
