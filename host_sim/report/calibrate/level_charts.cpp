#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "host_sim/report/calibrate/charts.hpp"
#include "host_sim/report/calibrate/notation.hpp"
#include "host_sim/report/page/number_text.hpp"

namespace host_sim::calibrate_page {
namespace {

/// Neighbours stand beside each other, so that equal lives can be distinguished.
double beside(std::size_t specimen) {
  constexpr std::size_t kColumns = 5;
  constexpr double kStep = 0.07;
  constexpr double kMiddle = 2;
  return (static_cast<double>(specimen % kColumns) - kMiddle) * kStep;
}

std::string category_of(const calibrate::LevelResult& level) {
  const std::string tension = quantity_text(level.load.effective_tension_N, "N");
  return level.load.bend_angle_deg ? angle_text(*level.load.bend_angle_deg) + "\n" + tension
                                   : tension;
}

Layer specimens(const calibrate::CalibrateResult& result, LevelKind part, bool failed) {
  Layer layer = specimen_points(part, failed, part == LevelKind::left_out ? "muted" : "line");
  if (part == LevelKind::validation) {
    layer.colour = "level-2";
  }
  for (std::size_t i = 0; i < result.levels.size(); ++i) {
    const calibrate::LevelResult& level = result.levels[i];
    for (std::size_t j = 0; kind_of(level) == part && j < level.sample.size(); ++j) {
      if (is_point(level.sample[j], failed)) {
        layer.x.push_back(static_cast<double>(i) + beside(j));
        layer.y.push_back(level.sample[j].value);
        layer.texts.push_back(level.specimens.at(j));
      }
    }
  }
  return layer;
}

Layer found_broken(const calibrate::CalibrateResult& result) {
  Layer layer = found_broken_bars();
  for (std::size_t i = 0; i < result.levels.size(); ++i) {
    const statistics::Sample& sample = result.levels[i].sample;
    for (std::size_t j = 0; j < sample.size(); ++j) {
      if (sample[j].from && !sample[j].trimmed) {
        layer.x.push_back(static_cast<double>(i) + beside(j));
        layer.y.push_back(*sample[j].from);
        layer.high.push_back(sample[j].value);
        layer.texts.push_back(result.levels[i].specimens.at(j));
      }
    }
  }
  return layer;
}

Layer means(const calibrate::CalibrateResult& result) {
  Layer layer;
  layer.kind = Layer::Kind::points;
  layer.name = "Mean life of the Weibull fit";
  layer.colour = "mark";
  layer.shape = "star";
  for (std::size_t i = 0; i < result.levels.size(); ++i) {
    if (has_fit(result.levels[i])) {
      layer.x.push_back(static_cast<double>(i));
      layer.y.push_back(result.levels[i].mean_life);
    }
  }
  return layer;
}

}  // namespace

Chart lives_chart(const calibrate::CalibrateResult& result) {
  struct Kind {
    LevelKind part;
    bool failed;
    const char* name;
  };
  constexpr Kind kKinds[] = {{LevelKind::fitted, true, "Failed"},
                             {LevelKind::fitted, false, "Suspended: lives longer"},
                             {LevelKind::validation, true, "Failed, validation"},
                             {LevelKind::validation, false, "Suspended, validation"},
                             {LevelKind::left_out, true, "Failed, left out"},
                             {LevelKind::left_out, false, "Suspended, left out"}};
  Chart chart;
  chart.id = "lives";
  chart.name = "The life of every specimen";
  chart.x = {"Level", Axis::Kind::category, "", {}, false};
  chart.y = {"Life, cycles", Axis::Kind::linear, "cycles", {}, true};
  for (const calibrate::LevelResult& level : result.levels) {
    chart.x.categories.push_back(category_of(level));
  }
  for (const Kind& kind : kKinds) {
    Layer layer = specimens(result, kind.part, kind.failed);
    layer.name = kind.name;
    chart.layers.push_back(layer);
  }
  chart.layers.push_back(found_broken(result));
  chart.layers.push_back(means(result));
  std::erase_if(chart.layers, [](const Layer& layer) { return layer.x.empty(); });
  return chart;
}

namespace {

Layer density(const statistics::Distribution& weibull) {
  constexpr std::size_t kPoints = 161;
  constexpr double kTail = 0.001;
  const double first = weibull.quantile(kTail);
  const double last = weibull.quantile(1 - kTail);
  Layer layer;
  for (std::size_t i = 0; i < kPoints; ++i) {
    const double life =
        first + (last - first) * static_cast<double>(i) / static_cast<double>(kPoints - 1);
    layer.x.push_back(life);
    layer.y.push_back(std::exp(weibull.log_density(life)));
  }
  return layer;
}

Layer lives(const calibrate::LevelResult& level) {
  Layer layer;
  layer.kind = Layer::Kind::rug;
  layer.width_px = 1;
  for (const statistics::Observation& specimen : level.sample) {
    if (is_point(specimen, true)) {
      layer.x.push_back(specimen.value);
    }
  }
  layer.y.assign(layer.x.size(), 0);
  return layer;
}

/// Suspended specimens stand near the foot of the level's curve, with an arrow to the longer lives.
Layer suspended(const calibrate::LevelResult& level) {
  constexpr double kOverFoot = 0.1;

  Layer layer = specimen_points(kind_of(level), false, "line");
  layer.arrow = Layer::Arrow::right;
  for (std::size_t i = 0; i < level.sample.size(); ++i) {
    if (is_point(level.sample[i], false)) {
      layer.x.push_back(level.sample[i].value);
      layer.texts.push_back(level.specimens.at(i) + " suspended at " + level.name());
    }
  }
  const double density_at_mean =
      std::exp(level.weibull().distribution.log_density(level.mean_life));
  layer.y.assign(layer.x.size(), kOverFoot * density_at_mean);
  return layer;
}

Layer mean(const calibrate::LevelResult& level) {
  Layer layer;
  layer.kind = Layer::Kind::points;
  layer.shape = "star";
  layer.x = {level.mean_life};
  layer.y = {std::exp(level.weibull().distribution.log_density(level.mean_life))};
  layer.texts = {"mean life at " + level.name()};
  return layer;
}

}  // namespace

Chart density_chart(const calibrate::CalibrateResult& result) {
  Chart chart;
  chart.id = "densities";
  chart.name = "Fitted Weibull densities";
  chart.x = {"Life, cycles", Axis::Kind::linear, "cycles", {}, false};
  chart.y = {"Density, per cycle", Axis::Kind::linear, "per cycle", {}, true};
  for (std::size_t i = 0; i < result.levels.size(); ++i) {
    const calibrate::LevelResult& level = result.levels[i];
    if (!has_fit(level)) {
      continue;
    }
    Layer curve = density(level.weibull().distribution);
    curve.name = title_of(level);
    curve.dashed = kind_of(level) != LevelKind::fitted;
    for (Layer layer : {curve, lives(level), suspended(level), mean(level)}) {
      layer.colour = colour_of(result, i);
      if (!layer.x.empty()) {
        chart.layers.push_back(std::move(layer));
      }
    }
  }
  return chart;
}

namespace {

using calibrate::CalibrateResult;
using calibrate::LevelResult;

constexpr double kFirstShare = 0.005;
constexpr double kLastShare = 0.995;

Chart probability_axes(std::string id, std::string name) {
  Chart chart;
  chart.id = std::move(id);
  chart.name = std::move(name);
  chart.x = {"Life, cycles", Axis::Kind::log, "cycles", {}, false};
  chart.y = {"Broken wires, %", Axis::Kind::weibull, "%", {}, false};
  return chart;
}

/// A Weibull distribution is a straight line on these axes.
Layer straight_line(const statistics::Distribution& weibull) {
  Layer layer;
  for (const double p : {kFirstShare, kLastShare}) {
    layer.x.push_back(weibull.quantile(p));
    layer.y.push_back(p);
  }
  return layer;
}

Layer band_outline(const statistics::QuantileBand& band) {
  Layer layer;
  layer.kind = Layer::Kind::area;
  layer.name = "95 % band of the lives";
  layer.x = band.low;
  layer.y = band.p;
  layer.x.insert(layer.x.end(), band.high.rbegin(), band.high.rend());
  layer.y.insert(layer.y.end(), band.p.rbegin(), band.p.rend());
  return layer;
}

Layer failures(const LevelResult& level) {
  Layer layer = specimen_points(kind_of(level), true, "line");
  for (const statistics::PlottingPosition& position : level.positions) {
    layer.x.push_back(position.life);
    layer.y.push_back(position.p);
    layer.texts.push_back(level.specimens.at(position.specimen));
  }
  return layer;
}

/// A line from each life that lies between two inspections back to the earlier one.
std::vector<Layer> back_to_inspections(const LevelResult& level) {
  std::vector<Layer> lines;
  for (const statistics::PlottingPosition& position : level.positions) {
    if (position.from > 0 && position.from < position.life) {
      Layer line;
      line.width_px = 1;
      line.x = {position.from, position.life};
      line.y = {position.p, position.p};
      lines.push_back(std::move(line));
    }
  }
  return lines;
}

/// Suspended specimens have no plotting position; they stand at the foot of the plot.
Layer suspended_at_the_foot(const LevelResult& level) {
  Layer layer = specimen_points(kind_of(level), false, "line");
  layer.name = "Suspended: lives longer";
  layer.arrow = Layer::Arrow::right;
  for (std::size_t i = 0; i < level.sample.size(); ++i) {
    if (is_point(level.sample[i], false)) {
      layer.x.push_back(level.sample[i].value);
      layer.texts.push_back(level.specimens.at(i));
    }
  }
  layer.y.assign(layer.x.size(), kFirstShare);
  return layer;
}

}  // namespace

Chart probability_chart(const CalibrateResult& result, std::size_t level_index) {
  const LevelResult& level = result.levels.at(level_index);
  Chart chart = probability_axes(fmt::format("probability-{}", level_index),
                                 "Probability plot of " + title_of(level));
  if (level.positions.empty()) {
    return chart;
  }
  if (has_fit(level)) {
    Layer line = straight_line(level.weibull().distribution);
    line.name = "Weibull fit";
    chart.layers = {band_outline(level.band), line};
  }
  for (Layer& line : back_to_inspections(level)) {
    chart.layers.push_back(std::move(line));
  }
  Layer failed = failures(level);
  failed.name = level.found_broken() > 0 ? "Failed, or found broken by then" : "Failed";
  chart.layers.push_back(failed);
  chart.layers.push_back(suspended_at_the_foot(level));
  for (Layer& layer : chart.layers) {
    layer.colour = colour_of(result, level_index);
  }
  std::erase_if(chart.layers, [](const Layer& layer) { return layer.x.empty(); });
  return chart;
}

Chart common_shape_chart(const CalibrateResult& result) {
  Chart chart = probability_axes("probability", "Probability plot of all levels");
  std::vector<statistics::Sample> samples;
  std::vector<std::size_t> fitted;
  for (std::size_t i = 0; i < result.levels.size(); ++i) {
    if (kind_of(result.levels[i]) == LevelKind::fitted && !result.levels[i].positions.empty()) {
      samples.push_back(result.levels[i].sample);
      fitted.push_back(i);
    }
  }
  if (result.common_shape) {
    const statistics::CommonShapeFit fit = statistics::fit_common_shape(samples);
    for (std::size_t i = 0; fit.problem == statistics::FitProblem::none && i < fitted.size(); ++i) {
      Layer line = straight_line({statistics::Family::weibull, fit.scales[i], fit.shape});
      line.colour = colour_of(result, fitted[i]);
      chart.layers.push_back(line);
    }
  }
  for (std::size_t i = 0; i < result.levels.size(); ++i) {
    Layer layer = failures(result.levels[i]);
    layer.name = title_of(result.levels[i]);
    layer.colour = colour_of(result, i);
    if (!layer.x.empty()) {
      chart.layers.push_back(layer);
    }
  }
  return chart;
}

std::vector<Chart> charts(const calibrate::CalibrateResult& result) {
  std::vector<Chart> all = {lives_chart(result),
                            density_chart(result),
                            scale_by_tension_chart(result),
                            scale_by_angle_chart(result),
                            stress_life_chart(result, StressLifeAxes::linear),
                            stress_life_chart(result, StressLifeAxes::logarithmic),
                            use_chart(result, StressLifeAxes::linear),
                            use_chart(result, StressLifeAxes::logarithmic),
                            common_shape_chart(result)};
  for (std::size_t i = 0; i < result.levels.size(); ++i) {
    all.push_back(probability_chart(result, i));
  }
  std::erase_if(all, [](const Chart& chart) { return chart.layers.empty(); });
  return all;
}

}  // namespace host_sim::calibrate_page
