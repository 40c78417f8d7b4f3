#pragma once

#include <span>
#include <vector>

namespace host_sim::statistics {

/// A life, or, where it was suspended, what it is longer than.
struct Observation {
  double value = 0;  ///< above 0
  bool failed = true;
};
using Sample = std::vector<Observation>;

enum class Family { normal, lognormal, weibull };

/// A life distribution with two parameters:
///   normal     location: mean, scale: standard deviation
///   lognormal  the same of the natural logarithm
///   weibull    scale: characteristic life alpha, shape: beta, eq. (15)
struct Distribution {
  Family family = Family::weibull;
  double first = 1;   ///< mean, mean of ln, or alpha
  double second = 1;  ///< standard deviation, that of ln, or beta

  [[nodiscard]] double cdf(double x) const;
  [[nodiscard]] double log_density(double x) const;
  [[nodiscard]] double log_survival(double x) const;
  /// Where `p`, 0 .. 1, have failed.
  [[nodiscard]] double quantile(double p) const;
  [[nodiscard]] double mean() const;
};

/// Sum over the failures of the log density and over the suspended of the log survival.
double log_likelihood(const Distribution& distribution, std::span<const Observation> sample);

}  // namespace host_sim::statistics
