#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "host_sim/statistics/fit.hpp"

namespace host_sim::statistics {

/// Largest distance between the Kaplan-Meier estimate and the distribution.
/// Both statistics need lives that are known: see KaplanMeier.
double kolmogorov_smirnov(const Distribution& distribution, std::span<const Observation> sample);

/// n times the integral of (F_n - F)^2 / (F (1 - F)) dF up to the last observation, with the
/// Kaplan-Meier estimate for F_n; without suspended specimens A^2 of Anderson and Darling.
double anderson_darling(const Distribution& distribution, std::span<const Observation> sample);

struct GoodnessOfFit {
  double ks = 0;
  double ks_p = 0;
  double ad = 0;
  double ad_p = 0;
};

struct BootstrapOptions {
  std::uint64_t seed = 1;
  std::uint64_t stream = 0;  ///< one for each use, so that uses do not share random numbers
  std::size_t replicates = 10'000;
  unsigned threads = 0;  ///< 0: all cores
};

/// Statistics of a fit with p-values by parametric bootstrap: each replicate is simulated from the
/// fit under the plan of suspension of the sample, and fitted again. p = (1 + exceedances) /
/// (1 + replicates that could be fitted). Where the lowest lives were dropped, both distances are
/// measured from the first life that was kept.
/// @pre fit.problem is none, and lives are known but for those that were dropped
GoodnessOfFit goodness_of_fit(const Fit& fit, std::span<const Observation> sample,
                              const BootstrapOptions& options);

/// Pointwise band for the quantiles of a Weibull fit.
struct QuantileBand {
  std::vector<double> p;          ///< rising
  std::vector<double> low, high;  ///< lives
};

/// Bootstrap band of `confidence` (0.95) at each p, by the pivots (ln t_p* - ln t_p) * beta*.
QuantileBand weibull_quantile_band(const Fit& fit, std::span<const Observation> sample,
                                   std::span<const double> p, double confidence,
                                   const BootstrapOptions& options);

/// A failure on a probability plot.
struct PlottingPosition {
  double life = 0;
  double p = 0;     ///< (adjusted rank - 0.3) / (n + 0.4): Benard's median rank
  double from = 0;  ///< where the life lies between two ends the lower of them, else the life
  std::size_t specimen = 0;  ///< in the sample
};

/// Failures in rising order, at the upper end where a life lies between two; ranks are adjusted for
/// suspended specimens by Johnson's method. Lives that were dropped have ranks but no place.
std::vector<PlottingPosition> plotting_positions(std::span<const Observation> sample);

}  // namespace host_sim::statistics
