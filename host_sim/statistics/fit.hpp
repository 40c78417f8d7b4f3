#pragma once

#include <span>

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

/// Fits one distribution to lives, suspended ones included.
Fit fit(Family family, std::span<const Observation> sample);

}  // namespace host_sim::statistics
