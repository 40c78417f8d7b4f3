#pragma once

#include <cmath>
#include <cstddef>

#include "host_sim/effects/tension_effect.hpp"

namespace host_sim::effects {

/// What to multiply a measured input by, tension or current, where a signature divides by it: the
/// root of T_in as the output tells it over T_in as measured, exp(r/2). The noise of the input is
/// part of r, so that a signature made of it alone would find an effect where there is none; in the
/// geometric mean of both ends noises of equal size cancel. 1 where the baseline holds exactly.
inline double to_mid_tension(const recording::Covariates& covariates, const Baseline& baseline,
                             std::size_t i) {
  const double gripped = std::exp(baseline.friction_coefficient * covariates.bend_angle_rad[i] *
                                  covariates.direction[i]);
  return std::sqrt(covariates.output_tension_N[i] * gripped / covariates.tension_in_N()[i]);
}

}  // namespace host_sim::effects
