#include "host_sim/statistics/goodness_of_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "host_sim/statistics/bootstrap.hpp"
#include "host_sim/statistics/distribution.hpp"
#include "host_sim/statistics/fit.hpp"

namespace host_sim::statistics {
namespace {

/// Distances between a sample and a distribution: see goodness_of_fit.hpp.
struct Distances {
  double ks = 0;
  double ad = 0;
};

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
    if (share == 0 && sample.dropped() > 0) {
      // Below the first life that was kept nothing is known of the share.
      from = height(distribution, step.value);
      share = sample.dropped();
    }
    go_to(height(distribution, step.value));
    share = step.after;
    result.ks = std::max(result.ks, std::abs(from.cdf - share));
  }
  go_to(sample.complete() ? kTop : height(distribution, sample.last()));
  result.ad *= sample.size();
  return result;
}

Distances distances_of(const Distribution& distribution, std::span<const Observation> sample) {
  KaplanMeier estimate;
  estimate.assign(sample);
  return distances(distribution, estimate);
}

/// Distances of samples drawn from a distribution to their own fits.
class DistanceReplicate {
 public:
  DistanceReplicate(const Distribution& truth, const CensoringPlan& plan)
      : truth_(truth), plan_(plan) {}

  Distances operator()(Random& random) {
    constexpr double kNotFitted = std::numeric_limits<double>::quiet_NaN();
    plan_.draw(truth_, random, drawn_);
    centred_.assign(truth_.family, drawn_);
    const Fit refit = fit(truth_.family, centred_);
    if (refit.problem != FitProblem::none) {
      return {.ks = kNotFitted, .ad = kNotFitted};
    }
    estimate_.assign(drawn_);
    return distances(refit.distribution, estimate_);
  }

 private:
  const Distribution& truth_;
  const CensoringPlan& plan_;
  Sample drawn_;
  CentredSample centred_;
  KaplanMeier estimate_;
};

}  // namespace

double kolmogorov_smirnov(const Distribution& distribution, std::span<const Observation> sample) {
  return distances_of(distribution, sample).ks;
}

double anderson_darling(const Distribution& distribution, std::span<const Observation> sample) {
  return distances_of(distribution, sample).ad;
}

GoodnessOfFit goodness_of_fit(const Fit& fit, std::span<const Observation> sample,
                              const BootstrapOptions& options) {
  const CensoringPlan plan(sample);
  std::vector<double> ks(options.replicates);
  std::vector<double> ad(options.replicates);
  for_each_replicate(options, [&] {
    return [&, replicate = DistanceReplicate(fit.distribution, plan)](Random& random,
                                                                      std::size_t i) mutable {
      const Distances drawn = replicate(random);
      ks[i] = drawn.ks;
      ad[i] = drawn.ad;
    };
  });
  const Distances observed = distances_of(fit.distribution, sample);
  return {.ks = observed.ks,
          .ks_p = bootstrap_p(ks, observed.ks),
          .ad = observed.ad,
          .ad_p = bootstrap_p(ad, observed.ad)};
}

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

/// (ln t_p* - ln t_p) beta* for each refit, where ln t_p* = ln alpha* + ln(-ln(1 - p)) / beta*.
std::vector<double> pivots(const Distribution& truth, std::span<const Distribution> refitted,
                           double p) {
  const double log_truth = std::log(truth.quantile(p));
  const double log_hazard = std::log(-std::log1p(-p));
  std::vector<double> result;
  result.reserve(refitted.size());
  for (const Distribution& one : refitted) {
    result.push_back((std::log(one.first) - log_truth) * one.second + log_hazard);
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

std::vector<PlottingPosition> plotting_positions(std::span<const Observation> sample) {
  std::vector<std::size_t> sorted(sample.size());
  std::iota(sorted.begin(), sorted.end(), std::size_t{0});
  std::ranges::stable_sort(sorted, [&sample](std::size_t one, std::size_t other) {
    return rises_failures_first(sample[one], sample[other]);
  });
  const auto size = static_cast<double>(sorted.size());
  std::vector<PlottingPosition> positions;
  double rank = 0;
  double remaining = size;
  for (const std::size_t specimen : sorted) {
    const Observation& seen = sample[specimen];
    if (seen.failed) {
      rank += (size + 1 - rank) / (1 + remaining);
      if (!seen.trimmed) {
        positions.push_back({.life = seen.value,
                             .p = (rank - 0.3) / (size + 0.4),
                             .from = seen.from.value_or(seen.value),
                             .specimen = specimen});
      }
    }
    --remaining;
  }
  return positions;
}

}  // namespace host_sim::statistics
