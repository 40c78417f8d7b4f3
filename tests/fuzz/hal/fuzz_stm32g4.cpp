// Any words in the message RAM and any bytes in the page of a node. Invariants: only frames that
// can be on a bus come out, and sending one puts the same words there; only nodes 1 .. 127 come
// out.

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <span>

#include "firmware/boards/b_g431b_esc1/node_page.hpp"
#include "hal/stm32g4/can_controller.hpp"

namespace {

using Element = hal::stm32g4::MessageElement<hal::stm32g4::Register>;

void require(bool holds, const char* what) {
  if (!holds) {
    std::fprintf(stderr, "does not hold: %s\n", what);
    std::abort();
  }
}

void check_message(const std::array<std::uint32_t, 4>& words) {
  Element element{};
  element.header[0].write(words[0]);
  element.header[1].write(words[1]);
  element.data[0].write(words[2]);
  element.data[1].write(words[3]);
  const auto frame = hal::stm32g4::take_message(element);
  require(frame.has_value() == ((words[0] >> 29 & 1u) == 0), "all but remote frames");
  if (!frame) {
    return;
  }
  require(frame->length <= 8, "at most 8 bytes");
  require(frame->id <= (frame->extended ? 0x1fff'ffffu : 0x7ffu), "an id in its range");
  for (std::size_t i = frame->length; i < 8; ++i) {
    require(frame->data[i] == std::byte{}, "zeros past the length");
  }
  Element again{};
  hal::stm32g4::put_message(again, *frame);
  require(hal::stm32g4::take_message(again) == frame, "a frame is read back");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::array<std::uint32_t, 4> words{};
  if (size >= sizeof words) {
    std::memcpy(words.data(), data, sizeof words);
    check_message(words);
  }
  if (size == boards::b_g431b_esc1::kNodeBytes) {
    const auto bytes =
        std::as_bytes(std::span<const std::uint8_t, boards::b_g431b_esc1::kNodeBytes>(data, size));
    const auto settings = boards::b_g431b_esc1::decode_node(bytes);
    require(!settings || (settings->node >= 1 && settings->node <= 127), "a node of CANopen");
  }
  return 0;
}
