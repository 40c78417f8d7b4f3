#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host_sim/calibrate/result.hpp"
#include "host_sim/report/calibrate/charts.hpp"
#include "host_sim/report/calibrate/notation.hpp"
#include "host_sim/report/page/chart.hpp"
#include "host_sim/report/page/number_text.hpp"

namespace host_sim::calibrate_page {
namespace {

/// The lowest and the highest tension of levels with constant load.
struct TensionRange {
  double low_N = 0;
  double high_N = 0;
};

void widen(TensionRange& range, double tension_N) {
  range = {std::min(range.low_N, tension_N), std::max(range.high_N, tension_N)};
}

/// Empty (low above high) without levels.
TensionRange tested_tensions_N(const calibrate::CalibrateResult& result) {
  TensionRange range{std::numeric_limits<double>::infinity(), 0};
  for (const calibrate::LevelResult& level : result.levels) {
    widen(range, level.load.effective_tension_N);
  }
  if (result.stress_life && result.stress_life->tested_N.low <= result.stress_life->tested_N.high) {
    widen(range, result.stress_life->tested_N.low);
    widen(range, result.stress_life->tested_N.high);
  }
  return range;
}

/// The same with the use levels.
TensionRange all_tensions_N(const calibrate::CalibrateResult& result) {
  TensionRange range = tested_tensions_N(result);
  for (const calibrate::UseLevel& use : result.use_levels) {
    widen(range, use.effective_tension_N);
  }
  return range;
}

/// A line of life over tension, a little beyond both ends of the range; empty for an empty range.
Layer law_line(TensionRange range, const std::function<double(double tension_N)>& life_cycles) {
  constexpr std::size_t kPoints = 121;
  constexpr double kBeyond = 1.04;
  Layer layer;
  if (range.low_N > range.high_N) {
    return layer;
  }
  const double first = range.low_N / kBeyond;
  const double ratio = range.high_N * kBeyond / first;
  for (std::size_t i = 0; i < kPoints; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(kPoints - 1);
    const double tension_N = first * std::pow(ratio, share);
    layer.x.push_back(tension_N);
    layer.y.push_back(life_cycles(tension_N));
  }
  return layer;
}

using calibrate::CalibrateResult;
using calibrate::LevelResult;
using Place = std::function<std::optional<double>(const LevelResult&)>;

/// Estimates as points over their intervals, one pair of layers for each part.
void add_scales(Chart& chart, const CalibrateResult& result, const Place& place) {
  constexpr std::pair<LevelKind, const char*> kParts[] = {
      {LevelKind::fitted, "Scale, fitted level"},
      {LevelKind::validation, "Scale, validation level"},
      {LevelKind::left_out, "Scale, left out"}};
  for (const auto& [part, name] : kParts) {
    Layer points = specimen_points(part, true, part == LevelKind::left_out ? "muted" : "line");
    points.name = name;
    Layer bars;
    bars.kind = Layer::Kind::bars;
    bars.colour = points.colour;
    for (const LevelResult& level : result.levels) {
      const std::optional<double> at = place(level);
      if (!at || !has_fit(level) || kind_of(level) != part) {
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

namespace {

using calibrate::StressLife;

// Layers that the plots of life over tension share.

/// The band within a range as an outline: forth along its upper side and back along the lower one.
Layer mean_band(const StressLife& law, TensionRange range) {
  constexpr double kBeyond = 1.06;  // a little more than what the band reaches beyond a use level
  Layer layer;
  layer.kind = Layer::Kind::area;
  layer.name = "95 % band of the mean";
  const std::size_t size = std::min(law.band_tension_N.size(), law.band_mean.size());
  for (std::size_t i = 0; i < 2 * size; ++i) {
    const std::size_t at = i < size ? i : 2 * size - 1 - i;
    const double life = i < size ? law.band_mean[at].high : law.band_mean[at].low;
    if (std::isfinite(life) && kBeyond * law.band_tension_N[at] >= range.low_N &&
        law.band_tension_N[at] <= kBeyond * range.high_N) {
      layer.x.push_back(law.band_tension_N[at]);
      layer.y.push_back(life);
    }
  }
  return layer;
}

Layer named(Layer layer, std::string_view name, std::string_view colour, bool dashed,
            double width_px) {
  layer.name = name;
  layer.colour = colour;
  layer.dashed = dashed;
  layer.width_px = width_px;
  return layer;
}

void add_if_any(Chart& chart, Layer layer) {
  if (!layer.x.empty()) {
    chart.layers.push_back(std::move(layer));
  }
}

Layer specimens(const CalibrateResult& result, LevelKind part, bool failed,
                std::string_view colour) {
  Layer layer = specimen_points(part, failed, colour);
  for (const LevelResult& level : result.levels) {
    for (std::size_t i = 0; kind_of(level) == part && i < level.sample.size(); ++i) {
      if (is_point(level.sample[i], failed)) {
        layer.x.push_back(level.load.effective_tension_N);
        layer.y.push_back(level.sample[i].value);
        layer.texts.push_back(specimen_text(level, i));
      }
    }
  }
  return layer;
}

Layer found_broken_by_tension(const CalibrateResult& result) {
  Layer layer = found_broken_bars();
  for (const LevelResult& level : result.levels) {
    for (std::size_t i = 0; i < level.sample.size(); ++i) {
      const statistics::Observation& specimen = level.sample[i];
      if (specimen.from.value_or(0) > 0 && !specimen.trimmed) {
        layer.x.push_back(level.load.effective_tension_N);
        layer.y.push_back(*specimen.from);
        layer.high.push_back(specimen.value);
        layer.texts.push_back(specimen_text(level, i));
      }
    }
  }
  return layer;
}

/// 95 % band of the mean, B10, mean and B90 of the law, and the paper's least squares.
void add_law(Chart& chart, const StressLife& law, TensionRange range) {
  constexpr double kThin = 1.5;
  constexpr double kThick = 2.5;
  const auto quantile = [&law](double p) {
    return [&law, p](double tension_N) { return law.law.quantile(p, tension_N); };
  };
  add_if_any(chart, mean_band(law, range));
  add_if_any(chart,
             named(law_line(range, quantile(0.9)), "B90 (90 % broken)", "level-3", false, kThin));
  add_if_any(
      chart,
      named(law_line(range, [&law](double tension_N) { return law.law.mean_life(tension_N); }),
            "Mean life", "line", false, kThick));
  add_if_any(chart,
             named(law_line(range, quantile(0.1)), "B10 (10 % broken)", "level-4", false, kThin));
  if (law.least_squares) {
    const life_law::LifeLaw& other = *law.least_squares;
    add_if_any(
        chart,
        named(law_line(range, [&other](double tension_N) { return other.mean_life(tension_N); }),
              "Mean life by least squares", "ink", true, kThin));
  }
}

/// Specimens of constant load: fitted, validation, left out; suspended with arrows.
void add_specimens(Chart& chart, const CalibrateResult& result) {
  struct Kind {
    LevelKind part;
    bool failed;
    const char* colour;
    const char* name;
  };
  constexpr Kind kKinds[] = {{LevelKind::left_out, true, "muted", "Failed, left out"},
                             {LevelKind::left_out, false, "muted", "Suspended, left out"},
                             {LevelKind::fitted, true, "line", "Failed"},
                             {LevelKind::fitted, false, "line", "Suspended: lives longer"},
                             {LevelKind::validation, true, "level-2", "Failed, validation"},
                             {LevelKind::validation, false, "level-2", "Suspended, validation"}};
  for (const Kind& kind : kKinds) {
    Layer layer = specimens(result, kind.part, kind.failed, kind.colour);
    layer.name = kind.name;
    add_if_any(chart, std::move(layer));
  }
  add_if_any(chart, found_broken_by_tension(result));
}

/// Names of left-out levels over their longest lives.
void add_left_out_names(Chart& chart, const CalibrateResult& result) {
  Layer labels;
  labels.kind = Layer::Kind::labels;
  labels.colour = "ink-soft";
  for (const LevelResult& level : result.levels) {
    if (kind_of(level) == LevelKind::left_out && !level.sample.empty()) {
      const auto longest =
          std::max_element(level.sample.begin(), level.sample.end(),
                           [](const auto& a, const auto& b) { return a.value < b.value; });
      labels.x.push_back(level.load.effective_tension_N);
      labels.y.push_back(longest->value);
      labels.texts.push_back((level.load.bend_angle_deg
                                  ? angle_text(*level.load.bend_angle_deg)
                                  : quantity_text(level.load.effective_tension_N, "N")) +
                             " left out");
    }
  }
  add_if_any(chart, std::move(labels));
}

using calibrate::UseLevel;

Chart axes_of(StressLifeAxes axes, std::string id, std::string name) {
  const bool linear = axes == StressLifeAxes::linear;
  const Axis::Kind kind = linear ? Axis::Kind::linear : Axis::Kind::log;
  Chart chart;
  chart.id = std::move(id);
  chart.name = std::move(name);
  chart.x = {"Effective tension, N", kind, "N", {}, false};
  chart.y = {"Life, cycles", kind, "cycles", {}, linear};
  return chart;
}

Layer bars(std::string name, std::string colour, double width_px) {
  Layer layer;
  layer.kind = Layer::Kind::bars;
  layer.name = std::move(name);
  layer.colour = std::move(colour);
  layer.width_px = width_px;
  return layer;
}

Layer points(std::string name, std::string colour, std::string_view shape, bool filled) {
  Layer layer;
  layer.kind = Layer::Kind::points;
  layer.name = std::move(name);
  layer.colour = std::move(colour);
  layer.shape = shape;
  layer.filled = filled;
  return layer;
}

void add_bar(Layer& layer, const UseLevel& use, statistics::Interval interval) {
  layer.x.push_back(use.effective_tension_N);
  layer.y.push_back(interval.low);
  layer.high.push_back(interval.high);
  layer.texts.push_back(use.name);
}

void add_use_levels(Chart& chart, const std::vector<UseLevel>& uses) {
  constexpr double kThin = 1.5;
  constexpr double kThick = 5;
  Layer next = bars("One more specimen, 95 %", "mark", kThin);
  Layer mean = bars("Mean life, 95 %", "mark", kThick);
  Layer predicted = points("Predicted mean at a use level", "ink", "star", true);
  Layer names;
  names.kind = Layer::Kind::labels;
  names.colour = "ink";
  for (const UseLevel& use : uses) {
    add_bar(next, use, use.next_specimen_95);
    add_bar(mean, use, use.mean_ci95);
    predicted.x.push_back(use.effective_tension_N);
    predicted.y.push_back(use.mean);
    predicted.texts.push_back(use.name);
    names.x.push_back(use.effective_tension_N);
    names.y.push_back(std::isfinite(use.next_specimen_95.high) ? use.next_specimen_95.high
                                                               : use.mean);
    names.texts.push_back(use.name);
  }
  chart.layers.insert(chart.layers.end(), {next, mean, predicted, names});
}

void add_validation(Chart& chart, const CalibrateResult& result) {
  Layer predicted = points("Predicted mean at a validation level", "ink", "square", false);
  Layer measured = points("Measured mean at a validation level", "ink", "square", true);
  for (const calibrate::ValidationResult& validation : result.validation) {
    if (validation.in_blocks) {
      continue;
    }
    const calibrate::LevelResult& level = result.levels.at(validation.level);
    predicted.x.push_back(level.load.effective_tension_N);
    predicted.y.push_back(validation.predicted_mean);
    predicted.texts.push_back(level.name());
    measured.x.push_back(level.load.effective_tension_N);
    measured.y.push_back(validation.measured_mean);
    measured.texts.push_back(level.name());
  }
  if (!predicted.x.empty()) {
    chart.layers.insert(chart.layers.end(), {predicted, measured});
  }
}

}  // namespace

Chart stress_life_chart(const CalibrateResult& result, StressLifeAxes axes) {
  Chart chart = axes == StressLifeAxes::linear
                    ? axes_of(axes, "stress-life", "Life over effective tension")
                    : axes_of(axes, "stress-life-log", "Life over effective tension, log-log");
  if (result.stress_life) {
    add_law(chart, *result.stress_life, tested_tensions_N(result));
  }
  add_specimens(chart, result);
  add_left_out_names(chart, result);
  return chart;
}

Chart use_chart(const CalibrateResult& result, StressLifeAxes axes) {
  Chart chart = axes == StressLifeAxes::linear
                    ? axes_of(axes, "use", "The law at use and validation levels")
                    : axes_of(axes, "use-log", "The law at use and validation levels, log-log");
  if (!result.stress_life || (result.use_levels.empty() && result.validation.empty())) {
    return chart;
  }
  add_law(chart, *result.stress_life, all_tensions_N(result));
  add_specimens(chart, result);
  add_validation(chart, result);
  if (!result.use_levels.empty()) {
    add_use_levels(chart, result.use_levels);
  }
  return chart;
}

}  // namespace host_sim::calibrate_page
