// Whatever frames at whatever times: histories within their limits, and a table whose lines have no
// control characters. Input: frames of 16 bytes, of which 2 are a step of time in ms, 2 flags and
// id, 1 the length, 8 data.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

#include "host_sim/monitor/fleet/fleet.hpp"
#include "host_sim/monitor/terminal/table.hpp"
#include "tests/fuzz/io/require.hpp"

namespace {

using host_sim::fuzz::require;
using host_sim::monitor::SeenFrame;

constexpr std::size_t kFrame = 16;

SeenFrame frame_of(std::span<const std::uint8_t> bytes, std::int64_t& time_ns) {
  SeenFrame seen;
  time_ns += (bytes[0] | bytes[1] << 8) * std::int64_t{1'000'000};
  seen.time_ns = time_ns;
  seen.frame.id = (bytes[2] | static_cast<std::uint32_t>(bytes[3]) << 8) & 0x7ff;
  seen.frame.extended = (bytes[3] & 0x10) != 0;
  seen.remote_request = (bytes[3] & 0x20) != 0;
  seen.frame.length = std::min<std::uint8_t>(bytes[4], 8);
  std::memcpy(seen.frame.data.data(), bytes.data() + 8, seen.frame.length);
  if ((bytes[3] & 0xc0) == 0xc0) {
    seen.error.emplace().bus_off = (bytes[4] & 1) != 0;
  }
  return seen;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  host_sim::monitor::Fleet fleet;
  std::int64_t time_ns = 0;
  for (std::size_t at = 0; at + kFrame <= size; at += kFrame) {
    fleet.see(frame_of(std::span(data + at, kFrame), time_ns));
  }
  fleet.tick(time_ns + 1);
  using host_sim::monitor::NodeView;
  for (const auto& [number, node] : fleet.view().nodes) {
    require(number >= 1 && number <= 127 && node.node == number);
    require(node.events.size() <= NodeView::kMostEvents);
    require(node.curve.size() <= NodeView::kMostPoints);
    require(!node.status || node.highest_damage_ppb != 0 || node.status->value.damage_ppb == 0);
  }
  for (const std::size_t width : {0u, 20u, 80u}) {
    for (const auto& line : host_sim::monitor::table_of(fleet.view(), {.width = width})) {
      require(width == 0 || line.size() <= width);
      require(std::none_of(line.begin(), line.end(), [](char c) { return c < ' ' || c > '~'; }));
    }
  }
  return 0;
}
