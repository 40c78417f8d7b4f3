#include <cmath>
#include <nlohmann/json.hpp>

#include "host_sim/plan/results.hpp"

namespace host_sim::plan {
namespace {

using nlohmann::ordered_json;

ordered_json number(double value) {
  return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
}

ordered_json optional_number(const std::optional<double>& value) {
  return value ? number(*value) : ordered_json(nullptr);
}

ordered_json level_json(const PlanRequest& request, const Outlook::Level& level) {
  ordered_json json{{"effective_tension_N", level.effective_tension_N},
                    {"specimens", level.specimens},
                    {"expected_failures", level.failures},
                    {"expected_cycles", level.cycles},
                    {"longest_cycles", level.longest_cycles}};
  if (request.cycles_per_minute) {
    json["days_on_one_rig"] = days_of(level.cycles, *request.cycles_per_minute);
    json["days_of_longest"] = days_of(level.longest_cycles, *request.cycles_per_minute);
  }
  return json;
}

ordered_json test_json(const PlanRequest& request, const PlannedTest& test) {
  ordered_json levels = ordered_json::array();
  for (const Outlook::Level& level : test.outlook.levels) {
    levels.push_back(level_json(request, level));
  }
  ordered_json json{{"name", test.name}};
  if (std::isfinite(request.goal.ratio)) {
    json["reached"] = test.reached;
    json["share_within"] = test.outlook.share_within;
  }
  json.update({{"specimens", test.outlook.specimens()},
               {"expected_failures", test.outlook.failures()},
               {"expected_cycles", test.outlook.cycles()},
               {"ratio_median", number(test.outlook.ratio_median)},
               {"ratio_at_assurance", number(test.outlook.ratio_at_assurance)},
               {"coverage", test.outlook.coverage},
               {"no_interval", test.outlook.no_interval},
               {"curvature_power", optional_number(test.curvature_power)},
               {"levels", levels}});
  return json;
}

ordered_json name_of(const PlanResult& result, const std::optional<std::size_t>& test) {
  return test ? ordered_json(result.tests[*test].name) : ordered_json(nullptr);
}

}  // namespace

std::string plan_json(const PlanRequest& request, const PlanResult& result) {
  const Conditions& conditions = request.conditions;
  ordered_json json{
      {"law",
       {{"ipl_scale", conditions.law.scale},
        {"ipl_exponent", conditions.law.exponent},
        {"weibull_shape", conditions.law.shape}}},
      {"use_tension_N", request.goal.use_tension_N},
      {"b10_cycles", result.b10_cycles},
      {"ratio", number(request.goal.ratio)},
      {"assurance", request.goal.assurance},
      {"suspend_at_cycles", number(conditions.suspend_at_cycles)},
      {"curvature_factor", request.curvature_factor},
      {"extrapolation",
       {{"tension_factor", result.extrapolation.tension_factor},
        {"life_factor", result.extrapolation.life_factor},
        {"ranges", result.extrapolation.ranges}}},
      {"simulations", request.simulation.simulations},
      {"seed", request.simulation.seed},
  };
  json["plans"] = ordered_json::array();
  for (const PlannedTest& test : result.tests) {
    json["plans"].push_back(test_json(request, test));
  }
  if (request.specimens.empty()) {
    json["specimens_max"] = request.specimens_max;
    json["reached"] = result.fewest_specimens.has_value();
    json["fewest_specimens"] = name_of(result, result.fewest_specimens);
    json["fewest_cycles"] = name_of(result, result.fewest_cycles);
    json["fewest_showing_curvature"] = name_of(result, result.fewest_showing_curvature);
  }
  return json.dump(2) + "\n";
}

}  // namespace host_sim::plan
