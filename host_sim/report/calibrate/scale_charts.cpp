#include <algorithm>
#include <functional>
#include <optional>

#include "host_sim/report/calibrate/charts.hpp"
#include "host_sim/report/calibrate/law_lines.hpp"
#include "host_sim/report/calibrate/level_look.hpp"
#include "host_sim/report/calibrate/scale_interval.hpp"

namespace host_sim::calibrate_page {
namespace {

using calibrate::CalibrateResult;
using calibrate::LevelResult;
using Place = std::function<std::optional<double>(const LevelResult&)>;

/// Estimates as points over their intervals, one pair of layers for each part.
void add_scales(Chart& chart, const CalibrateResult& result, const Place& place) {
  constexpr std::pair<Part, const char*> kParts[] = {{Part::fitted, "Scale, fitted level"},
                                                     {Part::validation, "Scale, validation level"},
                                                     {Part::left_out, "Scale, left out"}};
  for (const auto& [part, name] : kParts) {
    Layer points = specimen_points(part, true, part == Part::left_out ? "muted" : "line");
    points.name = name;
    Layer bars;
    bars.kind = Layer::Kind::bars;
    bars.colour = points.colour;
    for (const LevelResult& level : result.levels) {
      const std::optional<double> at = place(level);
      if (!at || !has_fit(level) || part_of(level) != part) {
        continue;
      }
      points.x.push_back(*at);
      points.y.push_back(level.weibull().distribution.first);
      points.texts.push_back(level.name());
      const std::optional<statistics::Interval> interval = scale_interval(level.band);
      if (interval) {
        bars.x.push_back(*at);
        bars.y.push_back(interval->low);
        bars.high.push_back(interval->high);
        bars.texts.push_back("95 % interval of the scale, " + level.name());
      }
    }
    if (!points.x.empty()) {
      chart.layers.push_back(bars);
      chart.layers.push_back(points);
    }
  }
}

/// Adds the angles as texts over the points.
void add_angles(Chart& chart, const CalibrateResult& result) {
  Layer labels;
  labels.kind = Layer::Kind::labels;
  labels.colour = "ink-soft";
  for (const LevelResult& level : result.levels) {
    if (has_fit(level) && level.load.bend_angle_deg) {
      labels.x.push_back(level.load.effective_tension_N);
      const std::optional<statistics::Interval> interval = scale_interval(level.band);
      labels.y.push_back(interval ? interval->high : level.weibull().distribution.first);
      labels.texts.push_back(angle_text(*level.load.bend_angle_deg));
    }
  }
  if (!labels.x.empty()) {
    chart.layers.push_back(labels);
  }
}

}  // namespace

Chart scale_by_tension_chart(const CalibrateResult& result) {
  Chart chart;
  chart.id = "scale-by-tension";
  chart.name = "Scale parameter against effective tension";
  chart.x = {"Effective tension, N", Axis::Kind::log, "N", {}, false};
  chart.y = {"Scale parameter, cycles", Axis::Kind::log, "cycles", {}, false};
  if (std::none_of(result.levels.begin(), result.levels.end(), has_fit)) {
    return chart;
  }
  if (result.stress_life) {
    const life_law::LifeLaw& law = result.stress_life->law;
    Layer line = law_line(tested_tensions_N(result),
                          [&law](double tension_N) { return law.characteristic_life(tension_N); });
    line.name = "Scale of the life law";
    chart.layers.push_back(line);
  }
  add_scales(chart, result,
             [](const LevelResult& level) { return level.load.effective_tension_N; });
  add_angles(chart, result);
  return chart;
}

Chart scale_by_angle_chart(const CalibrateResult& result) {
  Chart chart;
  chart.id = "scale-by-angle";
  chart.name = "Scale parameter against bend angle";
  chart.x = {"Bend angle, degrees", Axis::Kind::linear, "deg", {}, false};
  chart.y = {"Scale parameter, cycles", Axis::Kind::log, "cycles", {}, false};
  add_scales(chart, result, [](const LevelResult& level) { return level.load.bend_angle_deg; });
  return chart;
}

}  // namespace host_sim::calibrate_page
