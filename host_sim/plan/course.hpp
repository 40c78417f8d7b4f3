#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host_sim/plan/plan.hpp"

namespace host_sim::plan {

/// What so many specimens of one plan give.
struct CoursePoint {
  Outlook outlook;
  std::optional<double> curvature_power;  ///< none where it cannot show curvature
};

/// A plan with fewer and with more specimens, shared out over the levels as it shares them.
struct Course {
  std::string name;
  std::vector<CoursePoint> points;  ///< rising number of specimens
};

/// Of each test of a result, in its order: from the fewest specimens up to about twice its own.
/// `request.progress` is called anew with the share of tests done.
/// @throws Interruption
std::vector<Course> courses_of(const PlanRequest& request, const PlanResult& result);

}  // namespace host_sim::plan
