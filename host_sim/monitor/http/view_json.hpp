#pragma once

#include <nlohmann/json.hpp>

#include "host_sim/monitor/fleet/node_view.hpp"

/// Views as JSON. Messages have the names and physical values of the frame plan, times are whole
/// microseconds, what is not known is left out; there is no null.
namespace host_sim::monitor {

/// The bus and every node without its history.
nlohmann::json fleet_json(const FleetView& fleet);

/// What is known now.
nlohmann::json node_json(const NodeView& node);

/// Events and the damage curve, oldest first:
/// {"events": [..], "curve": [[time_us, damage, rate per hour], [time_us, damage], ..]}.
nlohmann::json history_json(const NodeView& node);

nlohmann::json event_json(const Event& event);

}  // namespace host_sim::monitor
