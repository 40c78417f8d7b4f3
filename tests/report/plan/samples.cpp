#include "tests/report/plan/samples.hpp"

#include <limits>
#include <utility>

namespace host_sim::samples {
namespace {

/// The law of the paper, levels near the use.
plan::PlanRequest request() {
  plan::PlanRequest request;
  request.conditions = {{1.53e5, 1.38, 5.94}, {42.5, 55, 70.8}};
  request.goal = {.use_tension_N = 38, .ratio = 1.5, .assurance = 0.8};
  request.specimens_max = 100;
  request.simulation = {.simulations = 100};
  return request;
}

PlanSample sample(std::string name, plan::PlanRequest request, std::size_t charts) {
  plan::PlanResult result = plan::make_plan(request);
  auto courses = plan::courses_of(request, result);
  return {std::move(name), std::move(request), std::move(result), std::move(courses), charts};
}

}  // namespace

const std::vector<PlanSample>& all_plans() {
  static const std::vector<PlanSample> all = [] {
    plan::PlanRequest missed = request();
    missed.goal.ratio = 1.01;
    missed.specimens_max = 12;
    plan::PlanRequest given = request();
    given.goal.ratio = std::numeric_limits<double>::infinity();
    given.specimens = {4, 0, 3};
    given.cycles_per_minute = 20;
    return std::vector<PlanSample>{sample("typical", request(), 2), sample("missed", missed, 2),
                                   sample("given", given, 1)};
  }();
  return all;
}

}  // namespace host_sim::samples
