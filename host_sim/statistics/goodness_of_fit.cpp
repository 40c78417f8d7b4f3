#include "host_sim/statistics/goodness_of_fit.hpp"

#include <limits>

#include "host_sim/statistics/censoring.hpp"
#include "host_sim/statistics/centred_sample.hpp"
#include "host_sim/statistics/distances.hpp"
#include "host_sim/statistics/replicates.hpp"

namespace host_sim::statistics {
namespace {

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

}  // namespace host_sim::statistics
