#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host_sim/statistics/common_shape.hpp"
#include "host_sim/statistics/fit.hpp"

namespace host_sim::life_law {

/// One specimen as the life model sees it.
struct LifeDatum {
  struct Block {
    double effective_tension_N = 0;  ///< above 0
    double cycles = 0;               ///< above 0
  };
  static constexpr std::size_t kNoLevel = static_cast<std::size_t>(-1);

  std::vector<Block> blocks;  ///< at least one, in order; a failure is at the end of the last
  bool failed = true;
  std::size_t level = kNoLevel;  ///< number of its level from 0; specimens in blocks have none
  /// Of a failure under one load that was found broken: see statistics::Observation.
  std::optional<double> from_cycles = {};
  bool trimmed = false;  ///< see statistics::Observation

  /// What is known of its cycles.
  /// @pre it has one block
  [[nodiscard]] statistics::Observation observation() const;
  /// The same load with other cycles.
  void observe(const statistics::Observation& seen);
};
using LifeData = std::vector<LifeDatum>;

/// The inverse power law with Weibull scatter: eqs. (19), (20).
struct LifeLaw {
  double scale = 0;     ///< A, in cycles times N^gamma
  double exponent = 0;  ///< gamma
  double shape = 0;     ///< beta

  /// alpha, eq. (19), in cycles.
  [[nodiscard]] double characteristic_life(double effective_tension_N) const;
  /// Eq. (21), in cycles.
  [[nodiscard]] double mean_life(double effective_tension_N) const;
  /// Cycles at which `p`, in 0 .. 1, of all specimens have failed: eq. (22).
  [[nodiscard]] double quantile(double p, double effective_tension_N) const;
};

/// What ln alpha and ln beta are made of; x is ln T_eff minus the centre.
struct LifeForm {
  enum class Scale {
    power_law,  ///< a - gamma x
    curved,     ///< a - gamma x + c x^2
    free,       ///< one for each level
  };
  enum class Shape {
    one,      ///< b
    growing,  ///< b + s x
    free,     ///< one for each level
  };
  Scale scale = Scale::power_law;
  Shape shape = Shape::one;
};

/// A maximum-likelihood fit of a form. Its numbers mean nothing where there is a problem.
struct LifeFit {
  LifeForm form;
  double centre_ln_N = 0;     ///< mean of ln T_eff over the failures' last blocks
  std::vector<double> scale;  ///< coefficients of ln alpha in the order of LifeForm::Scale
  std::vector<double> shape;  ///< coefficients of ln beta
  double log_likelihood = 0;  ///< densities per cycle
  statistics::FitProblem problem = statistics::FitProblem::none;

  /// @pre the form is a power law with one shape
  [[nodiscard]] LifeLaw law() const;
};

/// Fits by damped Newton steps with exact derivatives. A specimen in blocks enters with its
/// accumulated damage D = sum n_j / alpha_j: survival exp(-D^beta), and for a failure the density
/// of the last cycle, beta D^(beta - 1) exp(-D^beta) / alpha_last. One that was found broken enters
/// with the probability to break between its two ends. Under a growing shape the shape
/// of a specimen in blocks is that at the cycle-weighted mean of x. Forms with free levels take the
/// specimens that have a level, and skip the others; where scales are free, a level without
/// failures has an infinite ln alpha, adds nothing to the likelihood, and its own ln beta is not a
/// number. Problems: too_few_failures; no_spread where a shape grows without bound (all failures on
/// the law); not_identified where the likelihood is flat in a direction; not_converged.
LifeFit fit_life(std::span<const LifeDatum> data, LifeForm form = {});

/// The same from a start nearby, for replicates.
LifeFit fit_life(std::span<const LifeDatum> data, const LifeFit& start);

/// Log likelihood of data under a fit, e.g. of data that were not fitted.
double log_likelihood(std::span<const LifeDatum> data, const LifeFit& fit);

/// What an interval is wanted for. Tensions in newtons.
struct LifeQuantity {
  enum class Kind { ln_scale, exponent, shape, ln_mean_life, ln_quantile };
  Kind kind = Kind::exponent;
  double effective_tension_N = 0;  ///< for the mean life and the quantile
  double p = 0;                    ///< for the quantile
};

/// The interval in which the profile likelihood of the quantity stays within chi-square(1) of its
/// maximum; an end that does not exist is infinite.
/// @pre fit is a power law with one shape, without problem
statistics::Interval profile_interval(std::span<const LifeDatum> data, const LifeFit& fit,
                                      LifeQuantity quantity, double confidence = 0.95);

/// The effective tension at which ln of the characteristic life and the exponent do not correlate,
/// by the curvature of the likelihood at its maximum.
/// @pre fit is a power law with one shape, without problem
double pivot_tension_N(std::span<const LifeDatum> data, const LifeFit& fit);

/// The interval of x from that of ln x.
statistics::Interval exp_of(statistics::Interval of_ln);

/// Least squares of A / T^gamma against characteristic lives, in alpha, as the paper does in its
/// section 3.5.4.
/// @pre at least two lives above 0, at two different tensions
struct LeastSquares {
  double scale = 0;
  double exponent = 0;
  double rmse_cycles = 0;  ///< root of the mean square over the levels, n and not n - 2
};
LeastSquares fit_least_squares(std::span<const double> effective_tension_N,
                               std::span<const double> characteristic_life);

}  // namespace host_sim::life_law
