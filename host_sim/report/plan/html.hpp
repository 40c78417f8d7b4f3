#pragma once

#include <iosfwd>
#include <string_view>
#include <vector>

#include "host_sim/plan/course.hpp"
#include "host_sim/report/page/chart.hpp"

/// The plots of the page of a plan. A chart without anything to show has no layers.
namespace host_sim::plan_page {

/// High / low of the interval of B10 over the number of specimens, for each plan, with the wanted
/// ratio and the plans themselves marked.
[[nodiscard]] Chart width_chart(const plan::PlanRequest& request, const plan::PlanResult& result,
                                const std::vector<plan::Course>& courses);

/// Share of campaigns that show the curvature over what they cost: expected cycles, or days on one
/// rig where its speed is known.
[[nodiscard]] Chart told_chart(const plan::PlanRequest& request, const plan::PlanResult& result,
                               const std::vector<plan::Course>& courses);

}  // namespace host_sim::plan_page

namespace host_sim {

/// Writes one self-contained HTML page of a plan of a life test. The state of `out` shows whether
/// writing succeeded.
/// @param courses of the tests of the result
void write_plan_report(std::ostream& out, const plan::PlanRequest& request,
                       const plan::PlanResult& result, const std::vector<plan::Course>& courses,
                       std::string_view program_version);

}  // namespace host_sim
