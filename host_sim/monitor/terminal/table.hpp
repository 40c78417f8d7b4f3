#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "host_sim/monitor/fleet/node_view.hpp"

namespace host_sim::monitor {

struct TableStyle {
  std::size_t width = 0;  ///< columns of the terminal; 0: as wide as it is
  bool colours = false;
};

/// The fleet as lines without their ends: the bus, a head, and a row for each node, the gravest
/// first. Where the width is too small the notes are cut, then the least important columns left out
/// and named above the head; no value is ever parted from its mark.
std::vector<std::string> table_of(const FleetView& view, const TableStyle& style);

}  // namespace host_sim::monitor
