#include "host_sim/report/diagnose/charts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "host_sim/diagnose/output/prose.hpp"

namespace host_sim::diagnose_page {
namespace {

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
    for (std::size_t i = 0; i < diagnosis.tension->causes.size(); ++i) {
      all.push_back(cause_chart(*diagnosis.tension, i));
    }
    for (const std::size_t i : residual_order(*diagnosis.tension)) {
      all.push_back(residual_chart(*diagnosis.tension, i));
    }
    for (std::size_t i = 0; i < diagnosis.tension->remainders.size(); ++i) {
      all.push_back(remainder_chart(*diagnosis.tension, i));
    }
    all.push_back(session_chart(*diagnosis.tension, SessionParameter::friction));
    all.push_back(session_chart(*diagnosis.tension, SessionParameter::gain));
    all.push_back(gain_chart(diagnosis.tension->findings.gain));
    all.push_back(steps_chart(diagnosis.tension->findings));
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
