#pragma once

#include <string>

#include "host_sim/monitor/fleet/node_view.hpp"

namespace host_sim::monitor {

/// The damage curve of a node: time_s,damage,damage_rate_per_h; the rate is empty where none is
/// known.
std::string history_csv(const NodeView& node);

}  // namespace host_sim::monitor
