#include "host_sim/report/plan/html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

#include "host_sim/report/page/elements.hpp"
#include "host_sim/report/page/frame.hpp"
#include "host_sim/report/page/number_text.hpp"

/// Files of the page of a plan, embedded when the program is built.
namespace host_sim::plan_page_assets {

// NOLINTBEGIN(readability-identifier-naming): named after the files
extern const std::string_view body_html;
extern const std::string_view draw_js;
// NOLINTEND(readability-identifier-naming)

}  // namespace host_sim::plan_page_assets

namespace host_sim::plan_page {
namespace {

using plan::Course;
using plan::CoursePoint;
using plan::PlannedTest;
using plan::PlanRequest;
using plan::PlanResult;

constexpr double kPercent = 100;

std::string colour_of(std::size_t plan) {
  return fmt::format("level-{}", plan);
}

Layer horizontal(std::string name, double first_x, double last_x, double y) {
  Layer line;
  line.name = std::move(name);
  line.colour = "ink";
  line.dashed = true;
  line.width_px = 1.5;
  line.x = {first_x, last_x};
  line.y = {y, y};
  return line;
}

Layer star(std::size_t plan, double x, double y, std::string text) {
  Layer layer;
  layer.kind = Layer::Kind::points;
  layer.colour = colour_of(plan);
  layer.shape = "star";
  layer.x = {x};
  layer.y = {y};
  layer.texts = {std::move(text)};
  return layer;
}

/// In cycles, or days.
double cost_of(const PlanRequest& request, const plan::Outlook& outlook) {
  return request.cycles_per_minute ? plan::days_of(outlook.cycles(), *request.cycles_per_minute)
                                   : outlook.cycles();
}

/// From the least to the most of the lines.
std::pair<double, double> span_of(const std::vector<Layer>& lines) {
  std::pair<double, double> span{std::numeric_limits<double>::infinity(), 0};
  for (const Layer& line : lines) {
    for (const double x : line.x) {
      span = {std::min(span.first, x), std::max(span.second, x)};
    }
  }
  return span;
}

}  // namespace

Chart width_chart(const PlanRequest& request, const PlanResult& result,
                  const std::vector<Course>& courses) {
  Chart chart;
  chart.id = "width";
  chart.name = "Width of the interval of B10 over the number of specimens";
  chart.x = {"Specimens", Axis::Kind::log, "specimens", {}, false};
  chart.y = {"High / low of B10", Axis::Kind::log, "", {}, false};
  for (std::size_t i = 0; i < courses.size(); ++i) {
    Layer line;
    line.name = courses[i].name;
    line.colour = colour_of(i);
    for (const CoursePoint& point : courses[i].points) {
      if (std::isfinite(point.outlook.ratio_at_assurance)) {
        line.x.push_back(static_cast<double>(point.outlook.specimens()));
        line.y.push_back(point.outlook.ratio_at_assurance);
      }
    }
    if (!line.x.empty()) {
      chart.layers.push_back(std::move(line));
    }
  }
  if (std::isfinite(request.goal.ratio) && !chart.layers.empty()) {
    const auto [first, last] = span_of(chart.layers);
    chart.layers.push_back(horizontal("Wanted", first, last, request.goal.ratio));
  }
  for (std::size_t i = 0; i < result.tests.size(); ++i) {
    const PlannedTest& test = result.tests[i];
    if (std::isfinite(test.outlook.ratio_at_assurance)) {
      chart.layers.push_back(star(i, static_cast<double>(test.outlook.specimens()),
                                  test.outlook.ratio_at_assurance, test.name));
    }
  }
  return chart;
}

Chart told_chart(const PlanRequest& request, const PlanResult& result,
                 const std::vector<Course>& courses) {
  Chart chart;
  chart.id = "told";
  chart.name = "Cost and what it tells of the law";
  const std::string unit = request.cycles_per_minute ? "days" : "cycles";
  chart.x = {request.cycles_per_minute ? "Days on one rig" : "Cycles of all specimens",
             Axis::Kind::log,
             unit,
             {},
             false};
  chart.y = {"Curvature shown, %", Axis::Kind::linear, "%", {}, true};
  for (std::size_t i = 0; i < courses.size(); ++i) {
    Layer line;
    line.name = courses[i].name;
    line.colour = colour_of(i);
    for (const CoursePoint& point : courses[i].points) {
      if (point.curvature_power) {
        line.x.push_back(cost_of(request, point.outlook));
        line.y.push_back(kPercent * *point.curvature_power);
      }
    }
    if (!line.x.empty()) {
      chart.layers.push_back(std::move(line));
    }
  }
  if (chart.layers.empty()) {
    return chart;
  }
  const auto [first, last] = span_of(chart.layers);
  chart.layers.push_back(horizontal(fmt::format("Likely shown, {}", percent_text(plan::kGoodPower)),
                                    first, last, kPercent * plan::kGoodPower));
  for (std::size_t i = 0; i < result.tests.size(); ++i) {
    const PlannedTest& test = result.tests[i];
    if (test.curvature_power) {
      const double cost = cost_of(request, test.outlook);
      chart.layers.push_back(star(i, cost, kPercent * *test.curvature_power, test.name));
    }
  }
  return chart;
}

namespace {

using elements::tile;

std::string ratio_text(double ratio) {
  return std::isfinite(ratio) ? number_text(ratio, 4) : "no bound";
}

std::string power_text(const std::optional<double>& power) {
  return power ? percent_text(*power) : "never";
}

std::string wanted_text(const PlanRequest& request) {
  return fmt::format("high / low at most {} in {} of campaigns", number_text(request.goal.ratio, 4),
                     percent_text(request.goal.assurance));
}

std::string verdict_of(const PlanRequest& request, const PlanResult& result) {
  const std::string use = quantity_text(request.goal.use_tension_N, "N", 4);
  if (!request.specimens.empty()) {
    const plan::Outlook& outlook = result.tests.front().outlook;
    return fmt::format(
        "{} would give B10 at {} with an interval of high / low {} or less in {} of campaigns.",
        counted_text(outlook.specimens(), "specimen"), use, ratio_text(outlook.ratio_at_assurance),
        percent_text(request.goal.assurance));
  }
  if (!result.fewest_specimens) {
    return fmt::format("No plan of {} reaches what is wanted of B10 at {}: {}.",
                       counted_text(request.specimens_max, "specimen"), use, wanted_text(request));
  }
  const PlannedTest& fewest = result.tests[*result.fewest_specimens];
  const std::string text =
      fmt::format("B10 at {} takes {} ({}); ", use,
                  counted_text(fewest.outlook.specimens(), "specimen"), fewest.name);
  if (!result.fewest_showing_curvature) {
    return text + "no plan is likely to show whether the law is straight.";
  }
  const PlannedTest& checked = result.tests[*result.fewest_showing_curvature];
  return text + fmt::format("{} ({}) show as well whether the law is straight.",
                            count_text(checked.outlook.specimens()), checked.name);
}

std::string tiles(const PlanRequest& request, const PlanResult& result) {
  const plan::Extrapolation& beyond = result.extrapolation;
  std::string html =
      tile("B10 at the use", quantity_text(result.b10_cycles, "cycles"),
           "at " + quantity_text(request.goal.use_tension_N, "N", 4) + ", under the law");
  html += tile(
      "Wanted",
      std::isfinite(request.goal.ratio) ? number_text(request.goal.ratio, 4) : std::string("any"),
      fmt::format("high / low of the 95 % interval, in {} of campaigns",
                  percent_text(request.goal.assurance)));
  if (result.fewest_specimens) {
    const PlannedTest& fewest = result.tests[*result.fewest_specimens];
    const PlannedTest& shortest = result.tests[*result.fewest_cycles];
    html += tile("Fewest specimens", count_text(fewest.outlook.specimens()), fewest.name) +
            tile("Fewest cycles", number_text(shortest.outlook.cycles()), shortest.name);
  }
  return html + tile("Extrapolation",
                     beyond.ranges > 0 ? "\u00d7 " + number_text(beyond.tension_factor)
                                       : std::string("none"),
                     beyond.ranges > 0
                         ? fmt::format("in tension from the nearest level, {} in life",
                                       number_text(beyond.life_factor))
                         : std::string("the use lies between the levels"));
}

/// Of the tests that are worth making: what they leave unknown.
std::vector<std::string> warnings_of(const PlanRequest& request, const PlanResult& result) {
  constexpr double kFewFailures = 5;
  std::vector<std::string> warnings;
  for (const PlannedTest& test : result.tests) {
    if (!test.curvature_power) {
      warnings.push_back(fmt::format(
          "{}: {} levels fit any curvature, and B10 at the use rests on the law being straight.",
          test.name, test.design.tested_levels()));
    }
    if (test.outlook.no_interval > 0) {
      warnings.push_back(fmt::format("{}: no interval in {} of campaigns, with too few failures.",
                                     test.name, percent_text(test.outlook.no_interval)));
    }
    for (const plan::Outlook::Level& level : test.outlook.levels) {
      if (level.specimens > 0 && level.failures < kFewFailures) {
        warnings.push_back(
            fmt::format("{}: {} expected at {}; a level of so few says little of its own shape.",
                        test.name, quantity_text(level.failures, "failures"),
                        quantity_text(level.effective_tension_N, "N", 4)));
      }
    }
  }
  if (request.simulation.simulations < 1000) {
    warnings.push_back(fmt::format("Only {} campaigns were simulated of each plan.",
                                   request.simulation.simulations));
  }
  return warnings;
}

std::string plans_table(const PlanRequest& request, const PlanResult& result) {
  Table table("Plans", {"Plan", "Specimens by level", "All", "Failures", "Cycles", "Median",
                        "At the assurance", "Curvature shown", "Wanted"});
  for (const PlannedTest& test : result.tests) {
    std::string by_level;
    for (const plan::Outlook::Level& level : test.outlook.levels) {
      by_level += (by_level.empty() ? "" : ", ") + count_text(level.specimens);
    }
    table.row(test.name,
              {by_level, count_text(test.outlook.specimens()), number_text(test.outlook.failures()),
               number_text(test.outlook.cycles()), ratio_text(test.outlook.ratio_median),
               ratio_text(test.outlook.ratio_at_assurance), power_text(test.curvature_power),
               std::isinf(request.goal.ratio) ? "any" : (test.reached ? "reached" : "missed")});
  }
  return table.html();
}

std::string levels_table(const PlanRequest& request, const PlanResult& result) {
  const bool days = request.cycles_per_minute.has_value();
  constexpr const char* kLabel = "Levels of the plans";
  Table table = days ? Table(kLabel, {"Plan and level", "Specimens", "Failures", "Cycles of all",
                                      "The longest", "Days one by one", "Days all at once"})
                     : Table(kLabel, {"Plan and level", "Specimens", "Failures", "Cycles of all",
                                      "The longest"});
  for (const PlannedTest& test : result.tests) {
    for (const plan::Outlook::Level& level : test.outlook.levels) {
      if (level.specimens == 0) {
        continue;
      }
      std::vector<std::string> cells{count_text(level.specimens), number_text(level.failures),
                                     number_text(level.cycles), number_text(level.longest_cycles)};
      if (days) {
        for (const double cycles : {level.cycles, level.longest_cycles}) {
          cells.push_back(number_text(plan::days_of(cycles, *request.cycles_per_minute)));
        }
      }
      table.row(fmt::format("{}, {}", test.name, quantity_text(level.effective_tension_N, "N", 4)),
                cells);
    }
  }
  return table.html();
}

std::string courses_table(const std::vector<Course>& courses) {
  Table table("Plans with fewer and more specimens",
              {"Plan", "Specimens", "Cycles", "High / low", "Curvature shown"});
  for (const Course& course : courses) {
    for (const CoursePoint& point : course.points) {
      table.row(course.name,
                {count_text(point.outlook.specimens()), number_text(point.outlook.cycles()),
                 ratio_text(point.outlook.ratio_at_assurance), power_text(point.curvature_power)});
    }
  }
  return table.html();
}

}  // namespace
}  // namespace host_sim::plan_page

namespace host_sim {

void write_plan_report(std::ostream& out, const plan::PlanRequest& request,
                       const plan::PlanResult& result, const std::vector<plan::Course>& courses,
                       std::string_view program_version) {
  using namespace plan_page;
  const life_law::LifeLaw& law = request.conditions.law;
  const Chart width = width_chart(request, result, courses);
  const Chart told = told_chart(request, result, courses);
  Slots slots;
  slots["verdict"] = html_escape(verdict_of(request, result));
  slots["origin"] = html_escape(fmt::format(
      "Law: scale A {}, exponent gamma {}, Weibull shape {}. {} simulated campaigns of each plan, "
      "seed {}.",
      number_text(law.scale), number_text(law.exponent), number_text(law.shape),
      count_text(request.simulation.simulations), request.simulation.seed));
  slots["tiles"] = tiles(request, result);
  slots["warnings"] = elements::warnings(warnings_of(request, result));
  slots["width"] = elements::chart(
      width,
      "How far apart the ends of the 95 % interval of B10 at the use are in most campaigns, for "
      "each "
      "way to share the specimens out over the levels. A star is the plan of the table.",
      "No number of specimens that was tried bounds B10.");
  slots["told"] = elements::chart(
      told,
      fmt::format(
          "A law that is bent, so that the life at the use is {} times less than a straight "
          "one says: how many campaigns would show it, over what they cost. Plans of two "
          "levels never do.",
          number_text(request.curvature_factor)),
      "No plan here can show that the law is bent: two levels fit any curvature.");
  slots["courses_table"] = courses_table(courses);
  slots["plans_caption"] = html_escape(
      "Failures and cycles are expected, of all specimens. Median and at the assurance: high / low "
      "of the interval that so many campaigns keep to.");
  slots["plans_table"] = plans_table(request, result);
  slots["levels_table"] = levels_table(request, result);
  std::ostringstream body;
  fill_template(body, plan_page_assets::body_html, slots);
  nlohmann::json charts = nlohmann::json::object();
  for (const Chart* chart : {&width, &told}) {
    if (!chart->layers.empty()) {
      charts[chart->id] = chart_json(*chart);
    }
  }
  write_page(out, {"Tendon life: plan of a life test",
                   body.str(),
                   fmt::format("Made by host_sim {}.", program_version),
                   {{"charts", charts}},
                   plan_page_assets::draw_js});
}

}  // namespace host_sim
