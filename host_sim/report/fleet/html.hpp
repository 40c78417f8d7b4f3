#pragma once

#include <iosfwd>
#include <string_view>
#include <vector>

#include "host_sim/fleet/fleet_plan.hpp"

namespace host_sim {

/// Writes one self-contained HTML page: which tendons to replace when, the spares that it takes
/// until the horizon, the risk of each tendon, and what the policies cost. The state of `out` shows
/// whether writing succeeded.
/// @param source what stands for the fleet
void write_fleet_report(std::ostream& out, std::string_view source, const fleet::Fleet& fleet,
                        const fleet::PlanRequest& request, const fleet::FleetPlan& plan,
                        const std::vector<fleet::SparesUntil>& course,
                        std::string_view program_version);

}  // namespace host_sim
