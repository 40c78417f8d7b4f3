#include "host_sim/report/design/charts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "host_sim/report/page/number_text.hpp"

namespace host_sim::design_page {
namespace {

using design::Stress;
using design::Study;
using design::Tendon;

constexpr int kPoints = 160;

std::string angle_text(double angle_deg) {
  return number_text(angle_deg) + "\u00b0";
}

Layer mark(std::string name, double x, double y, std::string_view shape) {
  Layer layer;
  layer.kind = Layer::Kind::points;
  layer.name = std::move(name);
  layer.colour = "ink";
  layer.shape = shape;
  layer.x = {x};
  layer.y = {y};
  layer.texts = {""};
  return layer;
}

Layer label(std::string text, double x, double y) {
  Layer layer;
  layer.kind = Layer::Kind::labels;
  layer.colour = "ink";
  layer.x = {x};
  layer.y = {y};
  layer.texts = {std::move(text)};
  return layer;
}

bool has_value(const Layer& layer) {
  return std::any_of(layer.y.begin(), layer.y.end(), [](double y) { return std::isfinite(y); });
}

/// Effective tension over the bend angle as far as the wire holds.
Layer stress_line(const Model& model, Tendon tendon, double most_deg) {
  Layer layer;
  for (int i = 0; i <= kPoints; ++i) {
    tendon.bend_angle_deg = most_deg * i / kPoints;
    const Stress stress = stress_of(model, tendon);
    if (!stress.breaks_at_once()) {
      layer.x.push_back(tendon.bend_angle_deg);
      layer.y.push_back(stress.effective_tension_N);
    }
  }
  return layer;
}

}  // namespace

Chart life_chart(const Study& study) {
  Chart chart;
  chart.id = "life";
  chart.name = "Life over output tension";
  chart.x = {"Highest output tension, N", Axis::Kind::linear, "N", {}, false};
  chart.y = {fmt::format("Life at a risk of {}, cycles", percent_text(study.design.risk)),
             Axis::Kind::log,
             "cycles",
             {},
             false};
  const Tendon& own = study.design.tendon;
  std::size_t colour = 1;
  for (const design::Curve& curve : study.curves) {
    const bool is_own = curve.bend_angle_deg == own.bend_angle_deg;
    Layer line;
    line.name = angle_text(curve.bend_angle_deg) + (is_own ? ", the design" : "");
    line.colour = is_own ? "line" : fmt::format("level-{}", colour++);
    line.width_px = is_own ? 3 : 1.5;
    line.x = curve.output_max_N;
    line.y = curve.life_cycles;
    if (has_value(line)) {
      chart.layers.push_back(std::move(line));
    }
  }
  const double life_cycles = study.life_cycles;
  if (study.interval) {
    Layer bar;
    bar.kind = Layer::Kind::bars;
    bar.name = percent_text(study.interval->level) + " interval of the life";
    bar.colour = "ink";
    bar.x = {own.output_max_N};
    bar.y = {study.interval->low_cycles};
    bar.high = {study.interval->high_cycles};
    bar.texts = {""};
    chart.layers.push_back(std::move(bar));
  }
  if (std::isfinite(life_cycles)) {
    chart.layers.push_back(mark("The design", own.output_max_N, life_cycles, "star"));
    chart.layers.push_back(label(fmt::format("{}, {}", quantity_text(own.output_max_N, "N"),
                                             quantity_text(life_cycles, "cycles")),
                                 own.output_max_N, life_cycles));
  }
  if (study.design.found == design::Unknown::safety && std::isfinite(life_cycles)) {
    chart.layers.push_back(
        mark("The wanted life", own.output_max_N, study.design.life_cycles, "cross"));
  }
  return chart;
}

Chart stress_chart(const Model& model, const Study& study) {
  Chart chart;
  chart.id = "stress";
  chart.name = "Effective tension over bend angle";
  chart.x = {"Bend angle, degrees", Axis::Kind::linear, "deg", {}, true};
  chart.y = {"Effective tension, N", Axis::Kind::linear, "N", {}, true};
  constexpr double kLeastSpan_deg = 360;
  constexpr double kBeyond = 2;
  const Tendon& own = study.design.tendon;
  const double most_deg = std::max(kLeastSpan_deg, kBeyond * own.bend_angle_deg);
  const auto add = [&](double min_N, std::string name, std::string_view colour, double width_px) {
    Tendon tendon = own;
    tendon.output_min_N = min_N;
    Layer line = stress_line(model, tendon, most_deg);
    line.name = std::move(name);
    line.colour = colour;
    line.width_px = width_px;
    chart.layers.push_back(std::move(line));
  };
  constexpr double kThin = 1.5;
  constexpr double kThick = 3;
  const std::string high = quantity_text(own.output_max_N, "N");
  const bool constant = own.output_min_N == own.output_max_N;
  if (own.output_min_N > 0) {
    add(0, "From 0 to " + high, "level-1", kThin);
  }
  if (!constant) {
    add(own.output_max_N, "Constant " + high, "level-2", kThin);
  }
  add(own.output_min_N,
      constant ? "Constant " + high + ", the design"
               : fmt::format("From {} to {}, the design", number_text(own.output_min_N), high),
      "line", kThick);
  chart.layers.push_back(
      mark("The design", own.bend_angle_deg, study.stress.effective_tension_N, "star"));
  chart.layers.push_back(label(fmt::format("{}, {}", angle_text(own.bend_angle_deg),
                                           quantity_text(study.stress.effective_tension_N, "N")),
                               own.bend_angle_deg, study.stress.effective_tension_N));
  return chart;
}

Chart acceleration_chart(const Model& model, const Study& study) {
  Chart chart;
  chart.id = "acceleration";
  chart.name = "Acceleration factor of a test";
  chart.x = {"Highest output tension of the test, N", Axis::Kind::linear, "N", {}, false};
  chart.y = {"Acceleration factor", Axis::Kind::log, "", {}, false};
  if (!std::isfinite(study.stress.characteristic_life_cycles)) {
    return chart;
  }
  Tendon tendon = study.test ? study.test->tendon : study.design.tendon;
  const double ratio = study.design.tendon.load_ratio();
  const Stress stress = stress_of(model, tendon);
  const double first_N = std::min(study.design.tendon.output_max_N, tendon.output_max_N);
  const double last_N = stress.efficiency * stress.ultimate_tension_N;
  Layer line;
  line.name = fmt::format("At {}", angle_text(tendon.bend_angle_deg));
  line.width_px = 3;
  for (int i = 0; i < kPoints; ++i) {
    tendon.output_max_N = first_N + (last_N - first_N) * i / kPoints;
    tendon.output_min_N = ratio * tendon.output_max_N;
    line.x.push_back(tendon.output_max_N);
    line.y.push_back(study.stress.characteristic_life_cycles /
                     stress_of(model, tendon).characteristic_life_cycles);
  }
  chart.layers.push_back(std::move(line));
  if (study.test) {
    const double at_N = study.test->tendon.output_max_N;
    chart.layers.push_back(mark("The test", at_N, study.test->factor, "star"));
    chart.layers.push_back(label(number_text(study.test->factor), at_N, study.test->factor));
  }
  return chart;
}

std::vector<Chart> charts(const Model& model, const Study& study) {
  std::vector<Chart> all{life_chart(study), stress_chart(model, study),
                         acceleration_chart(model, study)};
  std::erase_if(all, [](const Chart& chart) { return chart.layers.empty(); });
  return all;
}

}  // namespace host_sim::design_page
