#include <algorithm>
#include <cmath>
#include <limits>

#include "host_sim/statistics/censoring.hpp"
#include "host_sim/statistics/centred_sample.hpp"
#include "host_sim/statistics/goodness_of_fit.hpp"
#include "host_sim/statistics/replicates.hpp"

namespace host_sim::statistics {
namespace {

/// Fits of samples drawn from a Weibull fit; those with a problem are left out.
std::vector<Distribution> refits(const Distribution& truth, std::span<const Observation> sample,
                                 const BootstrapOptions& options) {
  const CensoringPlan plan(sample);
  std::vector<Fit> fits(options.replicates);
  for_each_replicate(options, [&] {
    return [&, drawn = Sample(), logs = CentredSample()](Random& random, std::size_t i) mutable {
      plan.draw(truth, random, drawn);
      logs.assign(Family::weibull, drawn);
      fits[i] = fit(Family::weibull, logs);
    };
  });
  std::vector<Distribution> result;
  for (const Fit& one : fits) {
    if (one.problem == FitProblem::none) {
      result.push_back(one.distribution);
    }
  }
  return result;
}

/// (ln t_p* - ln t_p) beta* for each refit.
std::vector<double> pivots(const Distribution& truth, std::span<const Distribution> refitted,
                           double p) {
  const double log_truth = std::log(truth.quantile(p));
  std::vector<double> result;
  result.reserve(refitted.size());
  for (const Distribution& one : refitted) {
    result.push_back((std::log(one.quantile(p)) - log_truth) * one.second);
  }
  return result;
}

/// The value that is in its place when a share of `values` is sorted below it.
double order_statistic(std::vector<double>& values, double share) {
  if (values.empty()) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const auto last = static_cast<double>(values.size() - 1);
  const auto place = static_cast<std::ptrdiff_t>(std::lround(share * last));
  std::nth_element(values.begin(), values.begin() + place, values.end());
  return values[static_cast<std::size_t>(place)];
}

}  // namespace

QuantileBand weibull_quantile_band(const Fit& fit, std::span<const Observation> sample,
                                   std::span<const double> p, double confidence,
                                   const BootstrapOptions& options) {
  const Distribution& truth = fit.distribution;
  const std::vector<Distribution> refitted = refits(truth, sample, options);
  const double tail = (1 - confidence) / 2;
  QuantileBand band{.p = {p.begin(), p.end()}, .low = {}, .high = {}};
  for (const double share : p) {
    std::vector<double> drawn = pivots(truth, refitted, share);
    const double life = truth.quantile(share);
    band.low.push_back(life * std::exp(-order_statistic(drawn, 1 - tail) / truth.second));
    band.high.push_back(life * std::exp(-order_statistic(drawn, tail) / truth.second));
  }
  return band;
}

}  // namespace host_sim::statistics
