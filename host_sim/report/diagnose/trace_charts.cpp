#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "host_sim/report/diagnose/charts.hpp"

namespace host_sim::diagnose_page {
namespace {

using diagnose::TensionDiagnosis;
using diagnose::TracePicture;

constexpr double kMeasured_px = 4;  // shows below the simulated lines
constexpr double kSimulated_px = 1.5;

Layer line(std::string name, std::string_view colour, bool dashed, std::vector<double> x,
           std::vector<double> y) {
  Layer layer;
  layer.name = std::move(name);
  layer.colour = colour;
  layer.dashed = dashed;
  layer.width_px = kSimulated_px;
  layer.x = std::move(x);
  layer.y = std::move(y);
  return layer;
}

/// Measured, before and after over `x`.
std::vector<Layer> outputs(const TensionDiagnosis& tension, const TracePicture& trace,
                           const std::vector<double>& x) {
  if (x.empty() || x.size() != trace.measured_N.size()) {
    return {};
  }
  std::vector<Layer> layers{line("Measured", "muted", false, x, trace.measured_N)};
  layers.front().width_px = kMeasured_px;
  if (trace.before_N.size() == x.size()) {
    layers.push_back(line("Nominal model", kBeforeColour, true, x, trace.before_N));
  }
  if (trace.after_N.size() == x.size() && !tension.findings.extensions.empty()) {
    layers.push_back(line("Extended model", kAfterColour, false, x, trace.after_N));
  }
  return layers;
}

}  // namespace

double rmse_N(const std::vector<double>& measured_N, const std::vector<double>& simulated_N) {
  if (measured_N.empty() || measured_N.size() != simulated_N.size()) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const double squares =
      std::inner_product(measured_N.begin(), measured_N.end(), simulated_N.begin(), 0.0,
                         std::plus<>(), [](double measured, double simulated) {
                           return (measured - simulated) * (measured - simulated);
                         });
  return std::sqrt(squares / static_cast<double>(measured_N.size()));
}

std::vector<std::size_t> worst_traces(const TensionDiagnosis& tension, std::size_t most) {
  std::vector<double> errors_N;
  for (const TracePicture& trace : tension.traces) {
    const double error_N = rmse_N(trace.measured_N, trace.before_N);
    errors_N.push_back(std::isnan(error_N) ? -1 : error_N);
  }
  std::vector<std::size_t> order(errors_N.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&errors_N](std::size_t one, std::size_t other) {
    return errors_N[one] > errors_N[other];
  });
  order.resize(std::min(order.size(), most));
  return order;
}

Chart trace_chart(const TensionDiagnosis& tension, std::size_t trace_index) {
  const TracePicture& trace = tension.traces.at(trace_index);
  Chart chart;
  chart.id = fmt::format("trace-{}", trace_index);
  chart.name = "Output tension in session " + trace.session;
  chart.x = {"Time, s", Axis::Kind::linear, "s", {}, false};
  chart.y = {"Output tension, N", Axis::Kind::linear, "N", {}, false};
  chart.layers = outputs(tension, trace, trace.time_s);
  return chart;
}

Chart loop_chart(const TensionDiagnosis& tension, std::size_t trace_index) {
  const TracePicture& trace = tension.traces.at(trace_index);
  Chart chart;
  chart.id = fmt::format("loop-{}", trace_index);
  chart.name = "Loop of input and output tension in session " + trace.session;
  chart.x = {"Input tension, N", Axis::Kind::linear, "N", {}, false};
  chart.y = {"Output tension, N", Axis::Kind::linear, "N", {}, false};
  chart.layers = outputs(tension, trace, trace.input_N);
  return chart;
}

}  // namespace host_sim::diagnose_page
