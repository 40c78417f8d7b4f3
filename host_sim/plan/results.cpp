#include <fmt/ostream.h>

#include <cmath>
#include <set>

#include "host_sim/io/json.hpp"
#include "host_sim/plan/plan.hpp"

namespace host_sim::plan {
namespace {

using nlohmann::ordered_json;

ordered_json optional_number(const std::optional<double>& value) {
  return value ? json_number(*value) : ordered_json(nullptr);
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
               {"ratio_median", json_number(test.outlook.ratio_median)},
               {"ratio_at_assurance", json_number(test.outlook.ratio_at_assurance)},
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
      {"ratio", json_number(request.goal.ratio)},
      {"assurance", request.goal.assurance},
      {"suspend_at_cycles", json_number(conditions.suspend_at_cycles)},
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

namespace {

std::string percent(double share) {
  return fmt::format("{:.1f} %", 100 * share);
}

std::string ratio_text(double ratio) {
  return std::isfinite(ratio) ? fmt::format("{:.3f}", ratio) : "no bound";
}

void write_extrapolation(std::ostream& out, const Extrapolation& beyond) {
  if (beyond.ranges > 0) {
    fmt::print(out,
               "  extrapolation  {:.2f} times in tension and {:.2f} times in life from the nearest "
               "level, {:.2f} of the levels' range in ln T\n",
               beyond.tension_factor, beyond.life_factor, beyond.ranges);
  } else {
    fmt::print(out, "  extrapolation  none: the use lies between the levels\n");
  }
}

void write_head(std::ostream& out, const PlanRequest& request, const PlanResult& result) {
  const LifeLaw& law = request.conditions.law;
  fmt::print(out, "B10 at {:g} N: {:.0f} cycles under A {:g}, gamma {:g}, Weibull shape {:g}\n",
             request.goal.use_tension_N, result.b10_cycles, law.scale, law.exponent, law.shape);
  if (std::isfinite(request.goal.ratio)) {
    fmt::print(out,
               "  wanted         high / low of its 95 % interval at most {:g} in {:g} % of "
               "campaigns\n",
               request.goal.ratio, 100 * request.goal.assurance);
  }
  write_extrapolation(out, result.extrapolation);
  if (std::isfinite(request.conditions.suspend_at_cycles)) {
    fmt::print(out, "  suspension     at {:g} cycles\n", request.conditions.suspend_at_cycles);
  }
  fmt::print(out, "  simulated      {} campaigns of each plan, seed {}\n",
             request.simulation.simulations, request.simulation.seed);
}

/// One line for each plan: specimens by level and in all, and what they give.
void write_tests(std::ostream& out, const PlanRequest& request, const PlanResult& result) {
  fmt::print(out, "\n  {:<17}", "specimens at");
  for (const double level_N : request.conditions.levels_N) {
    fmt::print(out, "{:>8}", fmt::format("{:g} N", level_N));
  }
  fmt::print(out, "{:>7}{:>10}{:>10}{:>10}{:>10}{:>11}\n", "all", "failures", "cycles", "median",
             fmt::format("at {:g} %", 100 * request.goal.assurance), "curvature");
  for (const PlannedTest& test : result.tests) {
    fmt::print(out, "  {:<17}", test.name);
    for (const Outlook::Level& level : test.outlook.levels) {
      fmt::print(out, "{:>8}", level.specimens);
    }
    fmt::print(out, "{:>7}{:>10.1f}{:>10.0f}{:>10}{:>10}{:>11}{}\n", test.outlook.specimens(),
               test.outlook.failures(), test.outlook.cycles(),
               ratio_text(test.outlook.ratio_median), ratio_text(test.outlook.ratio_at_assurance),
               test.curvature_power ? percent(*test.curvature_power) : "never",
               test.reached ? "" : "  not reached");
  }
}

void write_legend(std::ostream& out, const PlanRequest& request) {
  fmt::print(out,
             "  failures, cycles: expected, of all specimens; median, at {:g} %: high / low that "
             "so many campaigns keep to\n"
             "  curvature: campaigns that would show, at 5 %, a law whose life at the use is {:g} "
             "times less than the straight one's\n",
             100 * request.goal.assurance, request.curvature_factor);
}

/// The cycles of one plan by level, with test time where the speed of a rig is known.
void write_levels(std::ostream& out, const PlanRequest& request, const PlannedTest& test) {
  fmt::print(out, "\n  {}, by level:\n", test.name);
  for (const Outlook::Level& level : test.outlook.levels) {
    if (level.specimens == 0) {
      continue;
    }
    fmt::print(out, "    {:g} N: {} specimens, {:.1f} failures, {:.0f} cycles, the longest {:.0f}",
               level.effective_tension_N, level.specimens, level.failures, level.cycles,
               level.longest_cycles);
    if (request.cycles_per_minute) {
      fmt::print(out, "; {:.3g} days one by one, {:.3g} all at once",
                 days_of(level.cycles, *request.cycles_per_minute),
                 days_of(level.longest_cycles, *request.cycles_per_minute));
    }
    fmt::print(out, "\n");
  }
}

/// What the campaigns of a plan leave unknown.
void write_limits(std::ostream& out, const PlanRequest& request, const PlannedTest& test) {
  if (!test.curvature_power) {
    fmt::print(out,
               "  {} cannot check the law: {} levels fit any curvature, and B10 at the use rests "
               "on the law being straight\n",
               test.name, test.design.tested_levels());
  } else if (*test.curvature_power < kGoodPower) {
    fmt::print(out,
               "  {} would miss such a curvature in {} of campaigns, and B10 would be {:g} times "
               "too long\n",
               test.name, percent(1 - *test.curvature_power), request.curvature_factor);
  }
  if (test.outlook.no_interval > 0) {
    fmt::print(out, "  {} gives no interval in {} of campaigns: too few failures\n", test.name,
               percent(test.outlook.no_interval));
  }
}

void write_choice(std::ostream& out, const PlanRequest& request, const PlanResult& result) {
  const PlannedTest& fewest = result.tests[*result.fewest_specimens];
  const PlannedTest& shortest = result.tests[*result.fewest_cycles];
  fmt::print(out, "\n  fewest specimens: {}, {}; fewest cycles: {}, {:.0f}\n", fewest.name,
             fewest.outlook.specimens(), shortest.name, shortest.outlook.cycles());
  std::set<std::size_t> chosen{*result.fewest_specimens, *result.fewest_cycles};
  if (result.fewest_showing_curvature) {
    const PlannedTest& checked = result.tests[*result.fewest_showing_curvature];
    fmt::print(out,
               "  fewest specimens that show such a curvature in {:g} % of campaigns: {}, {}\n",
               100 * kGoodPower, checked.name, checked.outlook.specimens());
    chosen.insert(*result.fewest_showing_curvature);
  } else {
    fmt::print(out, "  none shows such a curvature in {:g} % of campaigns\n", 100 * kGoodPower);
  }
  for (const std::size_t index : chosen) {
    write_limits(out, request, result.tests[index]);
  }
  for (const std::size_t index : chosen) {
    write_levels(out, request, result.tests[index]);
  }
}

/// A plan that was given, with the share of its campaigns that are as good as wanted.
void write_given(std::ostream& out, const PlanRequest& request, const PlannedTest& test) {
  if (std::isfinite(request.goal.ratio)) {
    fmt::print(out, "\n  {} reach {:g}\n", percent(test.outlook.share_within), request.goal.ratio);
  }
  write_limits(out, request, test);
  write_levels(out, request, test);
}

}  // namespace

void write_plan(std::ostream& out, const PlanRequest& request, const PlanResult& result) {
  write_head(out, request, result);
  write_tests(out, request, result);
  write_legend(out, request);
  if (!request.specimens.empty()) {
    write_given(out, request, result.tests.front());
  } else if (result.fewest_specimens) {
    write_choice(out, request, result);
  } else {
    fmt::print(out,
               "\n  not reached with {} specimens; lines above say what so many give. "
               "--specimens-max allows more\n",
               request.specimens_max);
  }
}

}  // namespace host_sim::plan
