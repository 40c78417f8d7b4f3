#include <cmath>

#include "host_sim/report/calibrate/charts.hpp"
#include "host_sim/report/calibrate/level_look.hpp"

namespace host_sim::calibrate_page {
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
    if (specimen.failed) {
      layer.x.push_back(specimen.value);
    }
  }
  layer.y.assign(layer.x.size(), 0);
  return layer;
}

/// Suspended specimens stand near the foot of the level's curve, with an arrow to the longer lives.
Layer suspended(const calibrate::LevelResult& level) {
  constexpr double kOverFoot = 0.1;

  Layer layer = specimen_points(part_of(level), false, "line");
  layer.arrow = Layer::Arrow::right;
  for (const statistics::Observation& specimen : level.sample) {
    if (!specimen.failed) {
      layer.x.push_back(specimen.value);
      layer.texts.push_back("suspended at " + level.name());
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
    curve.dashed = part_of(level) != Part::fitted;
    for (Layer layer : {curve, lives(level), suspended(level), mean(level)}) {
      layer.colour = colour_of(result, i);
      if (!layer.x.empty()) {
        chart.layers.push_back(std::move(layer));
      }
    }
  }
  return chart;
}

}  // namespace host_sim::calibrate_page
