#pragma once

#include "host_sim/recording/covariates.hpp"

namespace host_sim::recording {

/// Sums over samples that have travelled kSettledTravel_m or more since a reversal, of x = -phi s
/// and y = ln T_out/T_in: where y = gain + mu x, whatever acts at reversals. Zero where those are
/// fewer than a quarter of all.
struct SettledSums {
  double square = 0;   ///< of x about its mean in the recording
  double product = 0;  ///< of x and y about their means

  explicit SettledSums(const Covariates& covariates);
};

/// Friction coefficient of the settled samples, 0 where they are none or of one direction.
double settled_friction(const Covariates& covariates);

}  // namespace host_sim::recording
