#include "host_sim/plan/plan.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/plan/outlook.hpp"

namespace host_sim::plan {
namespace {

void report_progress(const PlanRequest& request, std::size_t done, std::size_t designs) {
  if (request.progress) {
    request.progress(static_cast<double>(done) / static_cast<double>(designs));
  }
}

PlannedTest given_test(const PlanRequest& request) {
  PlannedTest test;
  test.name = "given";
  test.design.suspend_at_cycles = request.conditions.suspend_at_cycles;
  for (std::size_t i = 0; i < request.specimens.size(); ++i) {
    test.design.levels.push_back({request.conditions.levels_N[i], request.specimens[i]});
  }
  test.outlook = look_out(request.conditions.law, test.design, request.goal, request.simulation);
  test.reached = test.outlook.reaches(request.goal);
  return test;
}

std::vector<PlannedTest> searched_tests(const PlanRequest& request) {
  const auto allocations =
      standard_allocations(request.conditions.levels_N, request.goal.use_tension_N);
  std::vector<PlannedTest> tests;
  for (const Allocation& allocation : allocations) {
    const Found found = least_specimens(request.conditions, allocation, request.goal,
                                        request.specimens_max, request.simulation);
    tests.push_back({allocation.name, found.reached, found.design, found.outlook, std::nullopt});
    report_progress(request, tests.size(), allocations.size() + 1);
  }
  return tests;
}

/// The first with the least of `cost` among the tests that reach the goal and are `fit`.
template <typename Cost, typename Fit>
std::optional<std::size_t> cheapest(const std::vector<PlannedTest>& tests, Cost cost, Fit fit) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < tests.size(); ++i) {
    if (tests[i].reached && fit(tests[i]) &&
        (!best || cost(tests[i].outlook) < cost(tests[*best].outlook))) {
      best = i;
    }
  }
  return best;
}

void choose(PlanResult& result) {
  const auto specimens = [](const Outlook& outlook) { return outlook.specimens(); };
  const auto cycles = [](const Outlook& outlook) { return outlook.cycles(); };
  const auto any = [](const PlannedTest&) { return true; };
  const auto shows_curvature = [](const PlannedTest& test) {
    return test.curvature_power && *test.curvature_power >= kGoodPower;
  };
  result.fewest_specimens = cheapest(result.tests, specimens, any);
  result.fewest_cycles = cheapest(result.tests, cycles, any);
  result.fewest_showing_curvature = cheapest(result.tests, specimens, shows_curvature);
}

}  // namespace

Extrapolation extrapolation_to(double use_tension_N, const Conditions& conditions) {
  const double lowest_N = conditions.levels_N.front();
  const double highest_N = conditions.levels_N.back();
  const double nearest_N = std::clamp(use_tension_N, lowest_N, highest_N);
  const double distance = std::abs(std::log(nearest_N / use_tension_N));
  return {std::exp(distance),
          conditions.law.characteristic_life(use_tension_N) /
              conditions.law.characteristic_life(nearest_N),
          distance / std::log(highest_N / lowest_N)};
}

double days_of(double cycles, double cycles_per_minute) {
  constexpr double kMinutesOfDay = 24 * 60;
  return cycles / cycles_per_minute / kMinutesOfDay;
}

PlanResult make_plan(const PlanRequest& request) {
  PlanResult result;
  result.b10_cycles = request.conditions.law.quantile(kB10, request.goal.use_tension_N);
  result.extrapolation = extrapolation_to(request.goal.use_tension_N, request.conditions);
  if (request.specimens.empty()) {
    result.tests = searched_tests(request);
  } else {
    result.tests.push_back(given_test(request));
  }
  for (PlannedTest& test : result.tests) {
    test.curvature_power = power_to_see({request.goal.use_tension_N, request.curvature_factor},
                                        request.conditions.law, test.design, request.simulation);
  }
  choose(result);
  return result;
}

}  // namespace host_sim::plan
