#include "host_sim/plan/course.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace host_sim::plan {
namespace {

constexpr int kSteps = 5;
constexpr double kBeyond = 2;  // times the specimens of the test

/// How a test shares its specimens out.
Allocation allocation_of(const PlannedTest& test, const PlanRequest& request) {
  const auto& levels_N = request.conditions.levels_N;
  const auto standard = standard_allocations(levels_N, request.goal.use_tension_N);
  const auto found = std::ranges::find(standard, test.name, &Allocation::name);
  if (request.specimens.empty() && found != standard.end()) {
    return *found;
  }
  Allocation allocation{test.name, {}};
  for (const PlannedLevel& level : test.design.levels) {
    allocation.weights.push_back(static_cast<double>(level.specimens));
  }
  return allocation;
}

/// Rising in ratio, with `own` among them.
std::set<std::size_t> totals_between(std::size_t fewest, std::size_t own) {
  const double first = static_cast<double>(fewest);
  const double last = std::max(kBeyond * static_cast<double>(own), first + kSteps);
  std::set<std::size_t> totals{std::max(own, fewest)};
  for (int i = 0; i <= kSteps; ++i) {
    totals.insert(static_cast<std::size_t>(
        std::lround(first * std::pow(last / first, static_cast<double>(i) / kSteps))));
  }
  return totals;
}

}  // namespace

std::vector<Course> courses_of(const PlanRequest& request, const PlanResult& result) {
  const SimulationOptions& options = request.simulation;
  const LifeLaw& law = request.conditions.law;
  std::vector<Course> courses;
  for (const PlannedTest& test : result.tests) {
    const Allocation allocation = allocation_of(test, request);
    Course course{test.name, {}};
    for (const std::size_t total :
         totals_between(fewest_specimens(allocation), test.design.specimens())) {
      const Design design = design_of(request.conditions, allocation, total);
      course.points.push_back({look_out(law, design, request.goal, options),
                               power_to_see({request.goal.use_tension_N, request.curvature_factor},
                                            law, design, options)});
    }
    courses.push_back(std::move(course));
    if (request.progress) {
      request.progress(static_cast<double>(courses.size()) /
                       static_cast<double>(result.tests.size()));
    }
  }
  return courses;
}

}  // namespace host_sim::plan
