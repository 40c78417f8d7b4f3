#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "host_sim/statistics/fit.hpp"

namespace host_sim::statistics {

/// A sample as the likelihood equations take it: lives (normal) or their logarithms (lognormal,
/// Weibull), less the largest of them, so that no power overflows and no digits are lost.
/// assign() again reuses the memory.
class CentredSample {
 public:
  CentredSample() = default;
  CentredSample(Family family, std::span<const Observation> sample) { assign(family, sample); }
  void assign(Family family, std::span<const Observation> sample);

  [[nodiscard]] std::span<const double> all() const { return values_; }
  [[nodiscard]] std::span<const double> failed() const { return all().first(failures_); }
  [[nodiscard]] std::span<const double> suspended() const { return all().subspan(failures_); }
  [[nodiscard]] std::size_t failures() const { return failures_; }
  [[nodiscard]] double largest() const { return largest_; }  ///< what was subtracted
  [[nodiscard]] double failed_mean() const { return failed_mean_; }
  /// Square root of the mean square distance of the failures from their mean.
  [[nodiscard]] double failed_deviation() const { return failed_deviation_; }
  /// The failures are at one value with nothing beyond it.
  [[nodiscard]] bool without_spread() const { return failed_mean_ >= 0; }

  /// too_few_failures or no_spread, where that keeps a family with two parameters from being
  /// fitted.
  [[nodiscard]] FitProblem problem() const;

 private:
  void copy(Family family, std::span<const Observation> sample);
  void measure_failures();

  std::vector<double> values_;  ///< failures first
  std::size_t failures_ = 0;
  double largest_ = 0;
  double failed_mean_ = 0;
  double failed_deviation_ = 0;
};

/// Maximum-likelihood fit of the family that the sample was centred for.
Fit fit(Family family, const CentredSample& sample);

}  // namespace host_sim::statistics
