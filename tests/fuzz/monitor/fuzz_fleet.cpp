// Whatever frames at whatever times: histories within their limits, and a table whose lines have no
// control characters. Input: see Frames.

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "host_sim/monitor/fleet/fleet.hpp"
#include "host_sim/monitor/terminal/table.hpp"
#include "tests/fuzz/io/require.hpp"
#include "tests/fuzz/monitor/frames.hpp"

using host_sim::fuzz::require;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  host_sim::monitor::Fleet fleet;
  host_sim::fuzz::Frames frames({data, size});
  while (const auto seen = frames.next()) {
    fleet.see(*seen);
  }
  fleet.tick(frames.time_ns() + 1);
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
