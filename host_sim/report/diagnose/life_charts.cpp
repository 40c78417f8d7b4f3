#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "host_sim/report/diagnose/charts.hpp"
#include "host_sim/statistics/goodness_of_fit.hpp"

namespace host_sim::diagnose_page {
namespace {

using diagnose::LifeDiagnosis;
using diagnose::LifePoint;

constexpr double kFirstShare = 0.005;
constexpr double kLastShare = 0.995;
constexpr std::size_t kColours = 6;

double ratio_of(const LifePoint& point, Model model) {
  return model == Model::nominal ? point.ratio_before : point.ratio_after;
}

std::string_view colour_of(Model model) {
  return model == Model::nominal ? kBeforeColour : kAfterColour;
}

std::string name_of(Model model) {
  return model == Model::nominal ? "Nominal model" : "Extended model";
}

/// What the model says: R = exp(-ratio^shape).
Layer model_line(double shape, Model model) {
  const statistics::Distribution weibull{statistics::Family::weibull, 1, shape};
  Layer layer;
  layer.name = name_of(model) + " says";
  layer.colour = colour_of(model);
  layer.dashed = model == Model::nominal;
  for (const double p : {kFirstShare, kLastShare}) {
    layer.x.push_back(weibull.quantile(p));
    layer.y.push_back(p);
  }
  return layer;
}

Layer failures(const LifeDiagnosis& lives, Model model) {
  statistics::Sample sample;
  for (const LifePoint& point : lives.picture.points) {
    sample.push_back({ratio_of(point, model), point.failed});
  }
  Layer layer;
  layer.kind = Layer::Kind::points;
  layer.name = "Failed, over the life of the " +
               std::string(model == Model::nominal ? "nominal" : "extended") + " model";
  layer.colour = colour_of(model);
  layer.shape = model == Model::nominal ? "circle" : "square";
  layer.filled = model == Model::extended;
  for (const statistics::PlottingPosition& position : statistics::plotting_positions(sample)) {
    layer.x.push_back(position.life);
    layer.y.push_back(position.p);
    layer.texts.push_back(lives.picture.points[position.specimen].specimen);
  }
  return layer;
}

void add_model(Chart& chart, const LifeDiagnosis& lives, Model model) {
  const double shape =
      model == Model::nominal ? lives.picture.shape_before : lives.picture.shape_after;
  if (shape > 0) {
    chart.layers.push_back(model_line(shape, model));
  }
  chart.layers.push_back(failures(lives, model));
}

std::vector<std::string> lots_of(const LifeDiagnosis& lives) {
  std::vector<std::string> lots;
  for (const LifePoint& point : lives.picture.points) {
    lots.push_back(point.lot);
  }
  std::sort(lots.begin(), lots.end());
  lots.erase(std::unique(lots.begin(), lots.end()), lots.end());
  return lots;
}

/// "lot A"; a name that says so itself stays.
std::string lot_name(const std::string& lot) {
  return lot.rfind("lot", 0) == 0 ? lot : "lot " + lot;
}

/// The specimens of one lot; of all lots where `lot` is null.
Layer specimens(const LifeDiagnosis& lives, const std::string* lot, bool failed, Model model) {
  Layer layer;
  layer.kind = Layer::Kind::points;
  layer.filled = failed;
  layer.arrow = failed ? Layer::Arrow::none : Layer::Arrow::up;
  for (const LifePoint& point : lives.picture.points) {
    if (point.failed == failed && (lot == nullptr || point.lot == *lot)) {
      layer.x.push_back(point.effective_N);
      layer.y.push_back(ratio_of(point, model));
      layer.texts.push_back(point.specimen);
    }
  }
  return layer;
}

void add_lot(Chart& chart, const LifeDiagnosis& lives, const std::string* lot,
             const std::string& colour, Model model) {
  const std::string of_lot = lot == nullptr ? "" : ", " + lot_name(*lot);
  for (const bool failed : {true, false}) {
    Layer layer = specimens(lives, lot, failed, model);
    layer.name = (failed ? "Failed" : "Suspended: lives longer") + of_lot;
    layer.colour = colour;
    if (!layer.x.empty()) {
      chart.layers.push_back(layer);
    }
  }
}

/// Where life is as predicted.
Layer as_predicted(const LifeDiagnosis& lives) {
  const auto [low, high] =
      std::minmax_element(lives.picture.points.begin(), lives.picture.points.end(),
                          [](const LifePoint& one, const LifePoint& other) {
                            return one.effective_N < other.effective_N;
                          });
  Layer layer;
  layer.name = "As predicted";
  layer.colour = "muted";
  layer.dashed = true;
  layer.x = {low->effective_N, high->effective_N};
  layer.y = {1, 1};
  return layer;
}

bool shows(const LifeDiagnosis& lives, Model model) {
  return !lives.picture.points.empty() &&
         (model == Model::nominal || !lives.findings.extensions.empty());
}

}  // namespace

Chart weibull_chart(const LifeDiagnosis& lives) {
  Chart chart;
  chart.id = "weibull";
  chart.name = "Weibull plot of the residual lives";
  chart.x = {"Life over the scale parameter of the model", Axis::Kind::log, "", {}, false};
  chart.y = {"Broken wires, %", Axis::Kind::weibull, "%", {}, false};
  for (const Model model : {Model::nominal, Model::extended}) {
    if (shows(lives, model)) {
      add_model(chart, lives, model);
    }
  }
  return chart;
}

Chart ratio_chart(const LifeDiagnosis& lives, Model model) {
  Chart chart;
  chart.id = model == Model::nominal ? "ratio-before" : "ratio-after";
  chart.name = "Life over predicted life by tension, " +
               std::string(model == Model::nominal ? "nominal model" : "extended model");
  chart.x = {"Effective tension, N", Axis::Kind::log, "N", {}, false};
  chart.y = {"Life over predicted life", Axis::Kind::log, "", {}, false};
  if (!shows(lives, model)) {
    return chart;
  }
  chart.layers.push_back(as_predicted(lives));
  const std::vector<std::string> lots = lots_of(lives);
  if (lots.size() < 2 || lots.size() > kColours) {
    add_lot(chart, lives, nullptr, std::string(colour_of(model)), model);
    return chart;
  }
  for (std::size_t i = 0; i < lots.size(); ++i) {
    add_lot(chart, lives, &lots[i], fmt::format("level-{}", i), model);
  }
  return chart;
}

}  // namespace host_sim::diagnose_page
