#include "host_sim/statistics/distances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace host_sim::statistics {
namespace {

/// The distribution at a life.
struct Height {
  double cdf;
  double log_cdf;
  double log_survival;
};
constexpr Height kBottom{
    .cdf = 0, .log_cdf = -std::numeric_limits<double>::infinity(), .log_survival = 0};
constexpr Height kTop{
    .cdf = 1, .log_cdf = 0, .log_survival = -std::numeric_limits<double>::infinity()};

Height height(const Distribution& distribution, double life) {
  const double cdf = distribution.cdf(life);
  return {.cdf = cdf, .log_cdf = std::log(cdf), .log_survival = distribution.log_survival(life)};
}

/// weight * (to - from), where infinities may stand for what has no weight.
double weighted_rise(double weight, double from, double to) {
  return weight == 0 || from == to ? 0 : weight * (to - from);
}

/// Integral of (share - F)^2 / (F (1 - F)) dF between two heights.
double squared_distance(double share, const Height& from, const Height& to) {
  return from.cdf - to.cdf + weighted_rise(share * share, from.log_cdf, to.log_cdf) -
         weighted_rise((1 - share) * (1 - share), from.log_survival, to.log_survival);
}

}  // namespace

Distances distances(const Distribution& distribution, const KaplanMeier& sample) {
  Distances result;
  Height from = kBottom;
  double share = 0;
  const auto go_to = [&](const Height& to) {
    result.ks = std::max(result.ks, std::abs(to.cdf - share));
    result.ad += squared_distance(share, from, to);
    from = to;
  };
  for (const KaplanMeier::Step& step : sample.steps()) {
    go_to(height(distribution, step.value));
    share = step.after;
    result.ks = std::max(result.ks, std::abs(from.cdf - share));
  }
  go_to(sample.complete() ? kTop : height(distribution, sample.last()));
  result.ad *= sample.size();
  return result;
}

}  // namespace host_sim::statistics
