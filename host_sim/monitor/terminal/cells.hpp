#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "host_sim/monitor/fleet/node_view.hpp"

namespace host_sim::monitor {

/// How a cell looks where there are colours. Words say the same.
enum class Look : std::uint8_t { plain, normal, inspect, replace, worn, unknown, stale, alarm };

struct Cell {
  std::string text;
  Look look = Look::plain;
};

/// What a node is called, shows and suffers from, a cell for each of kColumns.
std::vector<Cell> cells_of(const NodeView& node, std::int64_t now_ns);

/// A column of the table.
struct Column {
  std::string_view title;
  int importance = 0;  ///< where the terminal is narrow the lowest goes first
};

/// In the order of cells_of().
std::vector<Column> columns();

}  // namespace host_sim::monitor
