#pragma once

#include <string>

#include "host_sim/monitor/fleet/node_view.hpp"

namespace host_sim::monitor {

/// What a node reports of its life, as one JSON object; empty where it has reported nothing yet.
///
/// state (its gravest of this epoch; "two_controllers" where two report as this node at once, and
/// then also life_state, the graver one of theirs), quality (names of the schema), damage_ppb and
/// damage_percent (of the worst tendon, never falling but by a new epoch), worst_tendon,
/// storage_ok, sensor_ok, gap, saturated, overrun, locked, broken, slack, time_s (of the frame),
/// stale, vanished, integrity_failures; and where the node reports them and they are not stale
/// damage_percent_per_h, and remaining_h with b10, b50 and b90 (null: not known); and at_least, the
/// names of the values that stand for themselves or more.
std::string status_json(const NodeView& node);

}  // namespace host_sim::monitor
