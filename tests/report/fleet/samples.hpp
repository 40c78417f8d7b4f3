#pragma once

#include <string>
#include <vector>

#include "host_sim/fleet/fleet_plan.hpp"

namespace host_sim::samples {

struct FleetSample {
  std::string name;
  fleet::Fleet fleet;
  fleet::PlanRequest request;
  fleet::FleetPlan plan;
  std::vector<fleet::SparesUntil> course;
  int charts = 2;  ///< of its page
};

/// An old tendon at B10 that is due, a young one, one whose name is markup, and a broken one; with
/// costs.
FleetSample typical_fleet();
/// One tendon that does no damage, hours of operation, no costs.
FleetSample idle_fleet();

}  // namespace host_sim::samples
