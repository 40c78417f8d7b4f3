#include <cmath>
#include <utility>

#include "host_sim/report/calibrate/charts.hpp"
#include "host_sim/report/calibrate/stress_life_layers.hpp"

namespace host_sim::calibrate_page {
namespace {

using calibrate::CalibrateResult;
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
