#include "host_sim/report/diagnose/charts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "host_sim/diagnose/output/prose.hpp"

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

using diagnose::ResidualPicture;
using diagnose::TensionDiagnosis;

/// There and back: the outline of the envelope.
Layer envelope(const ResidualPicture& residual) {
  Layer layer;
  layer.kind = Layer::Kind::area;
  layer.name = "95 % of what noise and scatter of sessions alone give";
  layer.colour = "muted";
  layer.x = residual.centre;
  layer.y = residual.envelope_low;
  layer.x.insert(layer.x.end(), residual.centre.rbegin(), residual.centre.rend());
  layer.y.insert(layer.y.end(), residual.envelope_high.rbegin(), residual.envelope_high.rend());
  return layer;
}

void add_means(Chart& chart, const std::string& name, std::string_view colour,
               std::string_view shape, const std::vector<double>& x, const std::vector<double>& y) {
  Layer line;
  line.colour = colour;
  line.x = x;
  line.y = y;
  Layer points = line;
  points.kind = Layer::Kind::points;
  points.name = name;
  points.shape = shape;
  chart.layers.insert(chart.layers.end(), {line, points});
}

/// A unit as people write it.
std::string unit_text(const std::string& unit) {
  if (unit == "1") {
    return {};
  }
  return unit == "C" ? "\u00b0C" : unit;
}

/// How far the means of the nominal model leave the middle of their envelope, in half widths.
double excess_of(const ResidualPicture& residual) {
  double excess = 0;
  const std::size_t bins = std::min(
      {residual.before.size(), residual.envelope_low.size(), residual.envelope_high.size()});
  for (std::size_t i = 0; i < bins; ++i) {
    const double half = (residual.envelope_high[i] - residual.envelope_low[i]) / 2;
    const double middle = (residual.envelope_high[i] + residual.envelope_low[i]) / 2;
    if (half > 0) {
      excess = std::max(excess, std::abs(residual.before[i] - middle) / half);
    }
  }
  return excess;
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

std::vector<std::size_t> residual_order(const TensionDiagnosis& tension) {
  std::map<std::string, double> excess;
  for (const ResidualPicture& residual : tension.residuals) {
    double& most = excess[residual.covariate];
    most = std::max(most, excess_of(residual));
  }
  const auto key = [&](std::size_t i) {
    const std::string& covariate = tension.residuals[i].covariate;
    return std::pair(-excess.at(covariate), covariate);
  };
  std::vector<std::size_t> order(tension.residuals.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&key](std::size_t one, std::size_t other) { return key(one) < key(other); });
  return order;
}

Chart residual_chart(const TensionDiagnosis& tension, std::size_t residual_index) {
  const ResidualPicture& residual = tension.residuals.at(residual_index);
  const std::string covariate = diagnose::covariate_prose(residual.covariate);
  const std::string unit = unit_text(residual.unit);
  Chart chart;
  chart.id = fmt::format("residual-{}", residual_index);
  chart.name = fmt::format("Residual over {}, {}", covariate,
                           residual.direction > 0 ? "while pulling" : "while letting go");
  chart.x = {
      unit.empty() ? covariate : covariate + ", " + unit, Axis::Kind::linear, unit, {}, false};
  chart.y = {"Mean residual of ln(T_out / T_in)", Axis::Kind::linear, "", {}, false};
  if (residual.centre.empty()) {
    return chart;
  }
  if (residual.envelope_low.size() == residual.centre.size() &&
      residual.envelope_high.size() == residual.centre.size()) {
    chart.layers.push_back(envelope(residual));
  }
  add_means(chart, "Nominal model", kBeforeColour, "circle", residual.centre, residual.before);
  if (!tension.findings.extensions.empty()) {
    add_means(chart, "Extended model", kAfterColour, "square", residual.centre, residual.after);
  }
  return chart;
}

std::vector<Chart> charts(const diagnose::Diagnosis& diagnosis) {
  std::vector<Chart> all;
  if (diagnosis.tension) {
    for (const std::size_t trace : worst_traces(*diagnosis.tension, kMostTraces)) {
      all.push_back(trace_chart(*diagnosis.tension, trace));
      all.push_back(loop_chart(*diagnosis.tension, trace));
    }
    for (const std::size_t i : residual_order(*diagnosis.tension)) {
      all.push_back(residual_chart(*diagnosis.tension, i));
    }
  }
  if (diagnosis.lives) {
    all.push_back(weibull_chart(*diagnosis.lives));
    all.push_back(ratio_chart(*diagnosis.lives, Model::nominal));
    all.push_back(ratio_chart(*diagnosis.lives, Model::extended));
  }
  std::erase_if(all, [](const Chart& chart) { return chart.layers.empty(); });
  return all;
}

}  // namespace host_sim::diagnose_page
