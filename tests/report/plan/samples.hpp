#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "host_sim/plan/course.hpp"

/// Plans with few simulated campaigns, for the tests of their page.
namespace host_sim::samples {

struct PlanSample {
  std::string name;
  plan::PlanRequest request;
  plan::PlanResult result;
  std::vector<plan::Course> courses;
  std::size_t charts;  ///< plots of its page
};

/// One that is found, one that is not, one that was given with two levels and the speed of a rig.
[[nodiscard]] const std::vector<PlanSample>& all_plans();

}  // namespace host_sim::samples
