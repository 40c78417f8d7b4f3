#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "host_sim/diagnose/output/prose.hpp"
#include "host_sim/report/diagnose/charts.hpp"

namespace host_sim::diagnose_page {
namespace {

using diagnose::RemainderPicture;

/// Means with what their sessions scatter, `aside` of where they stand so that two are beside each
/// other.
void add_scatter(Chart& chart, const std::string& name, std::string_view colour,
                 std::string_view shape, double aside, const std::vector<double>& centre,
                 const std::vector<double>& mean_N, const std::vector<double>& sd_N) {
  if (mean_N.size() != centre.size() || sd_N.size() != centre.size()) {
    return;
  }
  Layer bars;
  bars.kind = Layer::Kind::bars;
  bars.name = name + ", \u00b1 1 standard deviation of sessions";
  bars.colour = colour;
  bars.width_px = 1.5;
  Layer points;
  points.kind = Layer::Kind::points;
  points.name = name;
  points.colour = colour;
  points.shape = shape;
  for (std::size_t i = 0; i < centre.size(); ++i) {
    bars.x.push_back(centre[i] + aside);
    bars.y.push_back(mean_N[i] - sd_N[i]);
    bars.high.push_back(mean_N[i] + sd_N[i]);
    points.x.push_back(centre[i] + aside);
    points.y.push_back(mean_N[i]);
  }
  chart.layers.insert(chart.layers.end(), {bars, points});
}

Layer zero_line(double low, double high) {
  Layer layer;
  layer.colour = "muted";
  layer.dashed = true;
  layer.width_px = 1;
  layer.x = {low, high};
  layer.y = {0, 0};
  return layer;
}

}  // namespace

Chart remainder_chart(const diagnose::TensionDiagnosis& tension, std::size_t index) {
  constexpr double kAside = 0.006;  // of the range
  const RemainderPicture& remainder = tension.remainders.at(index);
  const std::string covariate = diagnose::covariate_prose(remainder.covariate);
  Chart chart;
  chart.id = fmt::format("remainder-{}", index);
  chart.name = fmt::format("What remains over {}, {}", covariate,
                           remainder.direction > 0 ? "while pulling" : "while letting go");
  chart.x = {covariate + ", " + remainder.unit, Axis::Kind::linear, remainder.unit, {}, false};
  chart.y = {"Residual of the input tension, N", Axis::Kind::linear, "N", {}, false};
  if (remainder.centre.empty()) {
    return chart;
  }
  const auto [low, high] = std::ranges::minmax(remainder.centre);
  const double aside = kAside * (high - low);
  chart.layers.push_back(zero_line(low, high));
  add_scatter(chart, "Nominal model", kBeforeColour, "circle", -aside, remainder.centre,
              remainder.before_N, remainder.before_sd_N);
  if (remainder.after_N != remainder.before_N) {
    add_scatter(
        chart,
        tension.findings.extensions.empty() ? "As far as the catalogue goes" : "Extended model",
        kAfterColour, "square", aside, remainder.centre, remainder.after_N, remainder.after_sd_N);
  }
  return chart;
}

}  // namespace host_sim::diagnose_page
