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

/// Where samples before a place are missing: the time between two is more than this many usual
/// ones.
constexpr double kGap = 3;

double usual_interval_s(const std::vector<double>& time_s) {
  std::vector<double> intervals_s(time_s.size());
  std::adjacent_difference(time_s.begin(), time_s.end(), intervals_s.begin());
  intervals_s.erase(intervals_s.begin());
  const auto middle = intervals_s.begin() + static_cast<std::ptrdiff_t>(intervals_s.size() / 2);
  std::nth_element(intervals_s.begin(), middle, intervals_s.end());
  return *middle;
}

/// Values of a line that is not drawn where nothing was recorded: a value that is none stands in
/// each gap.
std::vector<double> with_gaps(const std::vector<double>& values,
                              const std::vector<std::size_t>& gaps) {
  std::vector<double> all;
  auto gap = gaps.begin();
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (gap != gaps.end() && *gap == i) {
      all.push_back(std::numeric_limits<double>::quiet_NaN());
      ++gap;
    }
    all.push_back(values[i]);
  }
  return all;
}

std::vector<double> part_of(const std::vector<double>& values, const Stretch& stretch) {
  return {values.begin() + static_cast<std::ptrdiff_t>(stretch.first),
          values.begin() + static_cast<std::ptrdiff_t>(stretch.last)};
}

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

/// Measured, before and after over `x`.
std::vector<Layer> outputs(const TensionDiagnosis& tension, const TracePicture& trace,
                           const std::vector<double>& x, const Stretch& stretch, int heads) {
  if (x.empty() || x.size() != trace.measured_N.size() || x.size() != trace.time_s.size()) {
    return {};
  }
  Lines lines(trace.time_s, x, stretch, heads);
  lines.add("Measured", "muted", trace.measured_N);
  lines.layers.front().width_px = kMeasured_px;
  if (trace.before_N.size() == x.size()) {
    lines.add("Nominal model", kBeforeColour, trace.before_N);
    lines.layers.back().dashed = true;
  }
  if (!tension.findings.extensions.empty()) {
    lines.add("Extended model", kAfterColour, trace.after_N);
  }
  return lines.layers;
}

}  // namespace

std::vector<std::size_t> gaps_in(const std::vector<double>& time_s) {
  std::vector<std::size_t> gaps;
  if (time_s.size() < 2) {
    return gaps;
  }
  const double most_s = kGap * usual_interval_s(time_s);
  for (std::size_t i = 1; i < time_s.size(); ++i) {
    if (time_s[i] - time_s[i - 1] > most_s) {
      gaps.push_back(i);
    }
  }
  return gaps;
}

Stretch cycles_in(const std::vector<double>& input_N) {
  constexpr double kBand = 0.75;  // standard deviations
  constexpr std::size_t kCycles = 2;
  double count = 0, sum = 0, square = 0;
  for (const double value : input_N) {
    if (std::isfinite(value)) {
      count += 1;
      sum += value;
      square += value * value;
    }
  }
  const double mean = sum / count;
  const double band = kBand * std::sqrt(std::max(0.0, square / count - mean * mean));
  std::vector<std::size_t> rises;
  bool below = false;
  for (std::size_t i = 0; i < input_N.size(); ++i) {
    if (below && input_N[i] > mean + band) {
      rises.push_back(i);
    }
    below = input_N[i] < mean - band || (below && !(input_N[i] > mean + band));
  }
  if (rises.size() < 2) {
    return {0, input_N.size()};
  }
  const std::size_t cycles = std::min(kCycles, rises.size() - 1);
  const std::size_t first = (rises.size() - 1 - cycles) / 2;
  return {rises[first], rises[first + cycles] + 1};
}

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
  chart.layers = outputs(tension, trace, trace.time_s, {0, trace.time_s.size()}, 0);
  return chart;
}

Chart loop_chart(const TensionDiagnosis& tension, std::size_t trace_index) {
  constexpr int kHeads = 4;
  const TracePicture& trace = tension.traces.at(trace_index);
  Chart chart;
  chart.id = fmt::format("loop-{}", trace_index);
  chart.name = "Loop of input and output tension in session " + trace.session;
  chart.x = {"Input tension, N", Axis::Kind::linear, "N", {}, false};
  chart.y = {"Output tension, N", Axis::Kind::linear, "N", {}, false};
  chart.layers = outputs(tension, trace, trace.input_N, cycles_in(trace.input_N), kHeads);
  return chart;
}

}  // namespace host_sim::diagnose_page
