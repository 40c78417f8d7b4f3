#pragma once

#include "host_sim/statistics/distribution.hpp"
#include "host_sim/statistics/kaplan_meier.hpp"

namespace host_sim::statistics {

/// Distances between a sample and a distribution: see goodness_of_fit.hpp.
struct Distances {
  double ks = 0;
  double ad = 0;
};
Distances distances(const Distribution& distribution, const KaplanMeier& sample);

}  // namespace host_sim::statistics
