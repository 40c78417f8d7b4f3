#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "host_sim/statistics/distribution.hpp"

namespace host_sim::statistics {

enum class FitProblem {
  none,
  too_few_failures,  ///< fewer than two
  no_spread,         ///< all failures at one life: the likelihood has no maximum
  not_identified,    ///< the data do not determine a coefficient, e.g. failures at one tension only
  not_converged,
};

/// A maximum-likelihood fit. Its numbers mean nothing where there is a problem.
struct Fit {
  Distribution distribution;
  double log_likelihood = 0;
  FitProblem problem = FitProblem::none;
};

/// Fits one distribution to lives: known, suspended, or between two ends.
Fit fit(Family family, std::span<const Observation> sample);

/// A sample as the likelihood equations take it: lives (normal) or their logarithms (lognormal,
/// Weibull), less the largest of them, so that no power overflows and no digits are lost.
/// assign() again reuses the memory.
class CentredSample {
 public:
  /// Of a life that is known to lie between.
  struct Ends {
    double low;  ///< minus infinity where nothing is known of it
    double high;
  };

  CentredSample() = default;
  CentredSample(Family family, std::span<const Observation> sample) { assign(family, sample); }
  void assign(Family family, std::span<const Observation> sample);

  [[nodiscard]] std::span<const double> all() const { return values_; }
  /// Failures whose life is known.
  [[nodiscard]] std::span<const double> failed() const { return all().first(exact_); }
  [[nodiscard]] std::span<const double> suspended() const { return all().subspan(exact_); }
  /// Failures whose life is known to lie between.
  [[nodiscard]] std::span<const Ends> between() const { return between_; }
  [[nodiscard]] std::size_t failures() const { return exact_ + between_.size(); }
  [[nodiscard]] double largest() const { return largest_; }  ///< what was subtracted
  /// Of failures, in the middle of their ends where they have two, else at the upper.
  [[nodiscard]] double failed_mean() const { return failed_mean_; }
  /// Square root of the mean square distance of the failures from their mean.
  [[nodiscard]] double failed_deviation() const { return failed_deviation_; }
  /// Root mean square distance from the mean of the failures, of them and of the suspended beyond.
  [[nodiscard]] double spread() const;
  /// All could have failed at one value: lives that are known are at one with nothing beyond.
  [[nodiscard]] bool without_spread() const { return latest_start_ <= earliest_end_; }
  /// Something holds the location from below and something from above.
  [[nodiscard]] bool bounded() const;

  /// too_few_failures or no_spread, where that keeps a family with two parameters from being
  /// fitted.
  [[nodiscard]] FitProblem problem() const;

 private:
  void copy(Family family, std::span<const Observation> sample);
  void centre();
  void measure_failures();

  std::vector<double> values_;  ///< failures first
  std::vector<Ends> between_;
  std::size_t exact_ = 0;
  double largest_ = 0;
  double latest_start_ = 0;  ///< largest of what lives are, or are longer than
  double earliest_end_ = 0;  ///< smallest of what lives are, or are at most
  double failed_mean_ = 0;
  double failed_deviation_ = 0;
};

/// Maximum-likelihood fit of the family that the sample was centred for.
Fit fit(Family family, const CentredSample& sample);

/// What keeps the samples from having a shape in common: too_few_failures (fewer than two in all)
/// or no_spread (no sample has any).
FitProblem shape_problem(std::span<const CentredSample> samples);

/// The Weibull shape of several samples with scales of their own: root of eq. (16), the censored
/// likelihood equation, over samples of logarithms; where lives lie between two ends, by Newton's
/// steps in all scales and the shape. Samples that are not bounded() say nothing.
/// @pre shape_problem is none
/// @return 0 where it did not converge
double solve_shape(std::span<const CentredSample> samples);

/// ln alpha of one sample at a shape. Infinite where the sample is not bounded().
double log_scale(const CentredSample& sample, double shape);

/// Log likelihood of the samples at a shape, each with its best scale.
double shape_log_likelihood(std::span<const CentredSample> samples, double shape);

}  // namespace host_sim::statistics
