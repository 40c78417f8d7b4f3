#pragma once

#include <cstdint>

#include "hal/can_frame.hpp"
#include "host_sim/monitor/fleet/node_view.hpp"

namespace host_sim::monitor {

/// Puts the page that a LifeDetail frame carries into its place; false, and nothing has happened,
/// where it is no page of the schema. Precondition: the frame passed the integrity check.
bool take_page(const hal::CanFrame& frame, std::int64_t time_ns, NodeView& view);

}  // namespace host_sim::monitor
