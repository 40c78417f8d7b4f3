#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>

#include "host_sim/report/diagnose/charts.hpp"

namespace host_sim::diagnose_page {
namespace {

using diagnose::TensionDiagnosis;
using diagnose::TracePicture;

constexpr double kMeasured_px = 4;  // shows below the simulated lines
constexpr double kSimulated_px = 1.5;

/// Lines of one stretch of a trace over `x`.
class Lines {
 public:
  Lines(const std::vector<double>& time_s, const std::vector<double>& x, const Stretch& stretch,
        int heads)
      : samples_(x.size()),
        stretch_(stretch),
        gaps_(gaps_in(part_of(time_s, stretch))),
        x_(with_gaps(part_of(x, stretch), gaps_)),
        heads_(heads) {}

  void add(const std::string& name, std::string_view colour, const std::vector<double>& y) {
    if (y.size() != samples_) {
      return;
    }
    Layer layer;
    layer.name = name;
    layer.colour = colour;
    layer.width_px = kSimulated_px;
    layer.heads = heads_;
    layer.x = x_;
    layer.y = with_gaps(part_of(y, stretch_), gaps_);
    layers.push_back(std::move(layer));
  }

  std::vector<Layer> layers;

 private:
  std::size_t samples_;
  Stretch stretch_;
  std::vector<std::size_t> gaps_;
  std::vector<double> x_;
  int heads_;
};

/// What the lines are called; none where there is no such line.
struct Names {
  std::string before, after;
};

Names names_of(const TensionDiagnosis& tension) {
  return {"Nominal model", tension.findings.extensions.empty() ? "" : "Extended model"};
}

/// Measured, before and after over `x`.
std::vector<Layer> outputs(const Names& names, const TracePicture& trace,
                           const std::vector<double>& x, const Stretch& stretch, int heads) {
  if (x.empty() || x.size() != trace.measured_N.size() || x.size() != trace.time_s.size()) {
    return {};
  }
  Lines lines(trace.time_s, x, stretch, heads);
  lines.add("Measured", "muted", trace.measured_N);
  lines.layers.front().width_px = kMeasured_px;
  if (trace.before_N.size() == x.size()) {
    lines.add(names.before, kBeforeColour, trace.before_N);
    lines.layers.back().dashed = true;
  }
  if (!names.after.empty()) {
    lines.add(names.after, kAfterColour, trace.after_N);
  }
  return lines.layers;
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
  chart.layers = outputs(names_of(tension), trace, trace.time_s, {0, trace.time_s.size()}, 0);
  return chart;
}

namespace {

Chart loop_of(std::string id, std::string name, const Names& names, const TracePicture& trace) {
  constexpr int kHeads = 4;
  Chart chart;
  chart.id = std::move(id);
  chart.name = std::move(name);
  chart.x = {"Input tension, N", Axis::Kind::linear, "N", {}, false};
  chart.y = {"Output tension, N", Axis::Kind::linear, "N", {}, false};
  chart.layers = outputs(names, trace, trace.input_N, cycles_in(trace.input_N), kHeads);
  return chart;
}

}  // namespace

Chart loop_chart(const TensionDiagnosis& tension, std::size_t trace_index) {
  const TracePicture& trace = tension.traces.at(trace_index);
  return loop_of(fmt::format("loop-{}", trace_index),
                 "Loop of input and output tension in session " + trace.session, names_of(tension),
                 trace);
}

Chart cause_chart(const TensionDiagnosis& tension, std::size_t cause_index) {
  const diagnose::CausePicture& cause = tension.causes.at(cause_index);
  return loop_of(
      fmt::format("cause-{}", cause_index),
      fmt::format("Loop without and with {} in session {}", cause.id, cause.trace.session),
      {"Without " + cause.id, "With " + cause.id}, cause.trace);
}

}  // namespace host_sim::diagnose_page
