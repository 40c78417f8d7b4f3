#include "host_sim/report/compare/html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

#include "host_sim/report/page/elements.hpp"
#include "host_sim/report/page/frame.hpp"
#include "host_sim/report/page/number_text.hpp"
#include "host_sim/report/replay/plot_builders.hpp"

/// Files of the page of a comparison, embedded when the program is built.
namespace host_sim::compare_assets {

// NOLINTBEGIN(readability-identifier-naming): named after the files
extern const std::string_view body_html;
extern const std::string_view draw_js;
// NOLINTEND(readability-identifier-naming)

}  // namespace host_sim::compare_assets

namespace host_sim {
namespace {

using compare::Comparison;
using compare::CycleClass;
using compare::Difference;
using compare::Side;

constexpr std::array<std::string_view, 2> kColours{"mark", "line"};

std::string file_of(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

std::string name_of(const Comparison& comparison, std::size_t side) {
  const Side& of = comparison.sides[side];
  return fmt::format("{}, {}", side == 0 ? "A" : "B",
                     file_of(comparison.of_models ? of.model : of.profile));
}

Layer layer_of(const Comparison& comparison, std::size_t side, Layer::Kind kind) {
  Layer layer;
  layer.kind = kind;
  layer.name = name_of(comparison, side);
  layer.colour = kColours.at(side);
  layer.dashed = side == 0 && kind == Layer::Kind::line;
  return layer;
}

/// Damage of all means by the lower end of the range.
std::map<double, double> damage_by_range(const Comparison& comparison, std::size_t side) {
  std::map<double, double> damage;
  for (const CycleClass& one : comparison.classes) {
    damage[one.range_N[0]] += one.damage[side];
  }
  return damage;
}

Chart classes_chart(const Comparison& comparison) {
  Chart chart;
  chart.id = "classes";
  chart.name = "Damage by the range of the cycles";
  chart.x = {"Range, N", Axis::Kind::linear, "N", {}, true};
  chart.y = {"Damage in a class", Axis::Kind::linear, "", {}, true};
  for (std::size_t side = 0; side < 2 && !comparison.classes.empty(); ++side) {
    const double width_N =
        comparison.classes.front().range_N[1] - comparison.classes.front().range_N[0];
    Layer stairs = layer_of(comparison, side, Layer::Kind::line);
    stairs.name.clear();
    Layer points = layer_of(comparison, side, Layer::Kind::points);
    points.shape = side == 0 ? "circle" : "square";
    double end_N = 0;
    for (const auto& [range_N, damage] : damage_by_range(comparison, side)) {
      if (range_N > end_N) {
        stairs.x.insert(stairs.x.end(), {end_N, range_N});
        stairs.y.insert(stairs.y.end(), {0, 0});
      }
      end_N = range_N + width_N;
      stairs.x.insert(stairs.x.end(), {range_N, end_N});
      stairs.y.insert(stairs.y.end(), {damage, damage});
      if (damage > 0) {
        points.x.push_back(range_N + width_N / 2);
        points.y.push_back(damage);
      }
    }
    stairs.x.push_back(end_N);
    stairs.y.push_back(0);
    chart.layers.insert(chart.layers.end(), {stairs, points});
  }
  return chart;
}

/// Times since the first one, in hours where the longer of both lasts some.
class Clock {
 public:
  explicit Clock(const Comparison& comparison) {
    constexpr double kHour_s = 3600;
    const double longest_s =
        std::max(comparison.a().report.duration_s, comparison.b().report.duration_s);
    if (longest_s > 2 * kHour_s) {
      unit_ = "h";
      unit_s_ = kHour_s;
    }
  }

  [[nodiscard]] Axis axis() const {
    return {
        std::string("Time since the first sample, ") + unit_, Axis::Kind::linear, unit_, {}, false};
  }
  [[nodiscard]] std::vector<double> since_first(const std::vector<double>& time_s) const {
    std::vector<double> since;
    since.reserve(time_s.size());
    for (const double at_s : time_s) {
      since.push_back((at_s - time_s.front()) / unit_s_);
    }
    return since;
  }

 private:
  const char* unit_ = "s";
  double unit_s_ = 1;
};

Chart trajectory_chart(const Comparison& comparison) {
  const Clock clock(comparison);
  Chart chart;
  chart.id = "trajectory";
  chart.name = "Damage over time";
  chart.x = clock.axis();
  chart.y = {"Damage", Axis::Kind::linear, "", {}, true};
  for (std::size_t side = 0; side < 2; ++side) {
    Layer line = layer_of(comparison, side, Layer::Kind::line);
    const Trajectory& trajectory = comparison.sides[side].report.trajectory;
    line.x = clock.since_first(trajectory.time_s);
    line.y = trajectory.damage;
    chart.layers.push_back(std::move(line));
  }
  return chart;
}

Chart tension_chart(const Comparison& comparison) {
  const Clock clock(comparison);
  Chart chart;
  chart.id = "tension";
  chart.name = "Input tension over time";
  chart.x = clock.axis();
  chart.y = {"Input tension, N", Axis::Kind::linear, "N", {}, false};
  for (std::size_t side = 0; side < 2; ++side) {
    const Envelope& envelope = comparison.sides[side].report.tension;
    Layer line = layer_of(comparison, side, Layer::Kind::line);
    line.width_px = 1;
    const std::vector<double> since = clock.since_first(envelope.time_s);
    for (std::size_t i = 0; i < since.size(); ++i) {
      line.x.insert(line.x.end(), {since[i], since[i]});
      line.y.insert(line.y.end(), {envelope.low_N[i], envelope.high_N[i]});
    }
    chart.layers.push_back(std::move(line));
  }
  return chart;
}

Chart life_chart(const Comparison& comparison) {
  constexpr double kPercent = 100;
  Chart chart;
  chart.id = "life";
  chart.name = "Broken wires over hours of operation";
  chart.x = {"Operation, h", Axis::Kind::linear, "h", {}, true};
  chart.y = {"Broken wires, %", Axis::Kind::linear, "%", {}, true};
  for (std::size_t side = 0; side < 2; ++side) {
    const Side& one = comparison.sides[side];
    const LifeCurve curve = life_curve(one.report.damage.total, one.report.weibull_shape);
    Layer line = layer_of(comparison, side, Layer::Kind::line);
    Layer b10 = layer_of(comparison, side, Layer::Kind::points);
    b10.name = "B10 of " + b10.name;
    for (std::size_t i = 0; i < curve.repeats.size(); ++i) {
      line.x.push_back(one.hours(curve.repeats[i]));
      line.y.push_back(kPercent * curve.broken[i]);
    }
    if (!line.x.empty()) {
      b10.x = {one.hours(one.report.repeats_to.B10)};
      b10.y = {10};
      chart.layers.insert(chart.layers.end(), {line, b10});
    }
  }
  return chart;
}

std::string factor_text(double factor) {
  return "\u00d7\u00a0" + number_text(factor, 4);
}

std::string quantity_table(const Comparison& comparison) {
  Table table("Side by side", {"Quantity", "A", "B", "B over A"});
  for (const compare::Quantity& quantity : quantities_of(comparison)) {
    const auto& [a, b] = quantity.values;
    table.row(quantity.name,
              {quantity_text(a, quantity.unit, 5), quantity_text(b, quantity.unit, 5),
               factor_text(compare::ratio(b, a))});
  }
  return table.html();
}

std::string value_text(const std::optional<double>& value) {
  return value ? number_text(*value, 6) : "none";
}

std::string differences_table(const std::vector<Difference>& differences) {
  Table table("What differs", {"Number of the model", "A", "B", "Life with this one alone"});
  for (const Difference& one : differences) {
    table.row(one.name, {value_text(one.a), value_text(one.b),
                         one.life_ratio ? factor_text(*one.life_ratio) : "not known"});
  }
  return table.html();
}

std::string differs(const Comparison& comparison) {
  std::string html;
  if (!comparison.of_models) {
    html = fmt::format("<p class=\"lead\">{}</p>\n", html_escape(first_of(comparison)));
  } else if (comparison.differences.empty()) {
    html = elements::empty("The models say the same.");
  } else {
    html =
        "<p class=\"caption\">What changes the life most stands first: how many times the B10 "
        "life of A it is with this number of B alone. Numbers of one extension are exchanged "
        "together.</p>\n" +
        differences_table(comparison.differences);
  }
  return html +
         fmt::format(
             "<p class=\"lead\">{}</p>\n",
             comparison.apart_s
                 ? fmt::format("The damages are apart by more than {} after {}.",
                               percent_text(compare::kApart), duration_text(*comparison.apart_s))
                 : fmt::format("The damages are never apart by more than {} while both last.",
                               percent_text(compare::kApart)));
}

std::string classes_table(const std::vector<CycleClass>& classes) {
  constexpr std::size_t kShown = 20;
  Table table("Classes of cycles", {"Range, N", "Mean, N", "Cycles of A", "Cycles of B",
                                    "Damage of A", "Damage of B", "B less A"});
  const auto span = [](const std::array<double, 2>& ends) {
    return fmt::format("{} to {}", number_text(ends[0], 4), number_text(ends[1], 4));
  };
  for (std::size_t i = 0; i < std::min(kShown, classes.size()); ++i) {
    const CycleClass& one = classes[i];
    table.row(span(one.range_N), {span(one.mean_N), number_text(one.cycles[0], 6),
                                  number_text(one.cycles[1], 6), number_text(one.damage[0]),
                                  number_text(one.damage[1]), number_text(one.more_damage())});
  }
  return elements::table_or(!classes.empty(), table.html(), "No cycle was counted.");
}

std::vector<std::string> warnings_of(const Comparison& comparison) {
  std::vector<std::string> all;
  for (std::size_t side = 0; side < 2; ++side) {
    for (const std::string& warning : comparison.sides[side].report.warnings) {
      all.push_back(name_of(comparison, side) + ": " + warning);
    }
  }
  return all;
}

std::string origin(const Comparison& comparison) {
  const Side& of = comparison.a();
  return comparison.of_models
             ? fmt::format("Both with profile {}; models {} and {}.", file_of(of.profile),
                           comparison.a().report.model_digest, comparison.b().report.model_digest)
             : fmt::format("Both with model {}, digest {}.", file_of(of.model),
                           comparison.a().report.model_digest);
}

}  // namespace

std::vector<Chart> compare_charts(const Comparison& comparison) {
  std::vector<Chart> all{classes_chart(comparison), trajectory_chart(comparison),
                         tension_chart(comparison), life_chart(comparison)};
  std::erase_if(all, [](const Chart& chart) { return chart.layers.empty(); });
  return all;
}

void write_compare_report(std::ostream& out, const Comparison& comparison,
                          std::string_view program_version) {
  const std::string title =
      fmt::format("{} and {}", name_of(comparison, 0), name_of(comparison, 1));
  Slots slots;
  slots["title"] = html_escape(title);
  slots["verdict"] = html_escape(sentence_of(comparison));
  slots["origin"] = html_escape(origin(comparison));
  slots["warnings"] = elements::warnings(warnings_of(comparison));
  slots["differs"] = differs(comparison);
  slots["quantities"] = quantity_table(comparison);
  slots["classes_chart"] = elements::chart(
      classes_chart(comparison), "Cycles of all means by their range; half cycles count half.",
      "No cycle was counted.");
  slots["classes_table"] = classes_table(comparison.classes);
  slots["trajectory"] =
      elements::chart(trajectory_chart(comparison), "Open cycles included as half cycles.", "");
  slots["tension"] = elements::chart(
      tension_chart(comparison),
      "At the input of the sheath; of long profiles from the lowest to the highest of "
      "neighbouring samples.",
      "");
  slots["life"] = elements::chart(life_chart(comparison),
                                  "Shares of wires broken after so many hours of this operation.",
                                  "There is no damage, and so no end of the life.");
  std::ostringstream body;
  fill_template(body, compare_assets::body_html, slots);
  nlohmann::json charts = nlohmann::json::object();
  for (const Chart& chart : compare_charts(comparison)) {
    charts[chart.id] = chart_json(chart);
  }
  write_page(out, {"Tendon life: " + title,
                   body.str(),
                   fmt::format("Made by host_sim {}.", program_version),
                   {{"charts", charts}},
                   compare_assets::draw_js});
}

}  // namespace host_sim
