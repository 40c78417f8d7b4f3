#pragma once

#include <vector>

#include "host_sim/diagnose/diagnosis.hpp"
#include "host_sim/diagnose/lives/fit.hpp"

namespace host_sim::diagnose::lives {

/// A coordinate's value with the interval in which its profile likelihood, with the priors of the
/// bounds of physics, stays within chi-square(1) of its maximum at 95 %.
struct CoordinateInterval {
  double value = 0, low = 0, high = 0;
};
CoordinateInterval profile_interval(const ModelView& view, const ModelFit& fit,
                                    Eigen::Index coordinate);

/// Of each parameter of each term, and of gamma, beta and A: refitted parameters that are no
/// effects. The interval of A holds gamma at its best.
struct ModelEstimates {
  std::vector<std::vector<Estimate>> terms;
  std::vector<Estimate> refitted;
};
ModelEstimates estimates_of(const ModelView& view, const ModelFit& fit, unsigned threads);

}  // namespace host_sim::diagnose::lives
