#include <fmt/format.h>

#include <utility>

#include "host_sim/report/calibrate/charts.hpp"
#include "host_sim/report/calibrate/level_look.hpp"

namespace host_sim::calibrate_page {
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
  Layer layer = specimen_points(part_of(level), true, "line");
  for (const statistics::PlottingPosition& position : level.positions) {
    layer.x.push_back(position.life);
    layer.y.push_back(position.p);
  }
  return layer;
}

/// Suspended specimens have no plotting position; they stand at the foot of the plot.
Layer suspended_at_the_foot(const LevelResult& level) {
  Layer layer = specimen_points(part_of(level), false, "line");
  layer.name = "Suspended: lives longer";
  layer.arrow = Layer::Arrow::right;
  for (const statistics::Observation& specimen : level.sample) {
    if (!specimen.failed) {
      layer.x.push_back(specimen.value);
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
  Layer failed = failures(level);
  failed.name = "Failed";
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
    if (part_of(result.levels[i]) == Part::fitted && !result.levels[i].positions.empty()) {
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

}  // namespace host_sim::calibrate_page
