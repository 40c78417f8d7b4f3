#pragma once

#include <nlohmann/json.hpp>

#include "host_sim/monitor/fleet/node_view.hpp"

namespace host_sim::monitor {

/// The events that `after` has and `before` has not, by node: {"5": [event, ..]}.
nlohmann::json new_events(const FleetView& before, const FleetView& after);

}  // namespace host_sim::monitor
