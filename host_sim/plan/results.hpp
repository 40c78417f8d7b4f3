#pragma once

#include <ostream>
#include <string>

#include "host_sim/plan/plan.hpp"

namespace host_sim::plan {

/// The result as JSON. What is infinite or does not exist is null.
std::string plan_json(const PlanRequest& request, const PlanResult& result);

/// The result for people.
void write_plan(std::ostream& out, const PlanRequest& request, const PlanResult& result);

}  // namespace host_sim::plan
