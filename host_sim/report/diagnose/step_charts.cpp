#include <algorithm>
#include <string>
#include <utility>

#include "host_sim/report/diagnose/charts.hpp"

namespace host_sim::diagnose_page {
namespace {

using diagnose::Findings;
using diagnose::HeldOutGain;
using diagnose::Step;

/// A staircase over the categories, each of its treads as wide as one, and a mark on each to read.
void add_stairs(Chart& chart, const std::string& name, const std::string& colour,
                std::string_view shape, const std::vector<double>& heights) {
  Layer stairs;
  stairs.colour = colour;
  Layer points;
  points.kind = Layer::Kind::points;
  points.name = name;
  points.colour = colour;
  points.shape = shape;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    const auto middle = static_cast<double>(i);
    stairs.x.insert(stairs.x.end(), {middle - 0.5, middle + 0.5});
    stairs.y.insert(stairs.y.end(), {heights[i], heights[i]});
    points.x.push_back(middle);
    points.y.push_back(heights[i]);
  }
  chart.layers.insert(chart.layers.end(), {stairs, points});
}

void add_output(Chart& chart, const std::vector<double>& errors_N) {
  add_stairs(chart, "Output tension from input tension", "level-2", "circle", errors_N);
}

void add_input(Chart& chart, const std::vector<double>& errors_N) {
  add_stairs(chart, "Input tension from output tension", "level-3", "square", errors_N);
}

/// "friction\npreload" of "friction_preload": in lines, as there is little room below an axis.
std::string label_of(const Step& step) {
  if (step.effect.id.empty()) {
    return "Nominal\nmodel";
  }
  std::string label = step.effect.id;
  std::ranges::replace(label, '_', '\n');
  return label;
}

Chart error_chart(std::string id, std::string name, std::vector<std::string> models) {
  Chart chart;
  chart.id = std::move(id);
  chart.name = std::move(name);
  chart.x = {"Model", Axis::Kind::category, "", std::move(models), false};
  chart.y = {"Error held out (RMSE), N", Axis::Kind::linear, "N", {}, true};
  return chart;
}

}  // namespace

Chart steps_chart(const Findings& findings) {
  std::vector<std::string> models;
  std::vector<double> output_N, input_N;
  for (const Step& step : findings.steps) {
    models.push_back(label_of(step));
    output_N.push_back(step.output_rmse_N);
    input_N.push_back(step.input_rmse_N);
  }
  Chart chart = error_chart("steps", "Error held out, one effect more at each step", models);
  if (!models.empty()) {
    add_output(chart, output_N);
    add_input(chart, input_N);
  }
  return chart;
}

Chart gain_chart(const HeldOutGain& gain) {
  Chart chart = error_chart("gain", "Error held out, from the nominal to the extended model",
                            {"Nominal\nmodel", "Extended\nmodel"});
  for (const diagnose::Metric& metric : gain.metrics) {
    if (metric.name == "rmse_N") {
      add_output(chart, {metric.before, metric.after});
    } else if (metric.name == "input_rmse_N") {
      add_input(chart, {metric.before, metric.after});
    }
  }
  return chart;
}

}  // namespace host_sim::diagnose_page
