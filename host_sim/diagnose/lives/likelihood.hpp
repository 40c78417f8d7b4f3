#pragma once

#include <vector>

#include "host_sim/diagnose/lives/life_sample.hpp"
#include "host_sim/diagnose/lives/life_settings.hpp"

namespace host_sim::diagnose::lives {

/// Log likelihood of lives, suspended ones included; densities per cycle. A draw that a lot or a
/// group shares is integrated over by Gauss and Hermite about its mode.
/// @pre lots and groups do not scatter both
double log_likelihood(const LifeSample& sample, const LifeSettings& settings);

/// What a fitted model leaves of each specimen.
struct Residual {
  double cox_snell = 0;  ///< -ln of the probability to survive its cycles: standard exponential
  double shared = 0;     ///< the most probable draw of its lot or group, in ln N
};
std::vector<Residual> residuals_of(const LifeSample& sample, const LifeSettings& settings);

/// Probability that a specimen of an unknown lot survives the cycles that it has.
double survival(const LifeSample& sample, const LifeSample::Specimen& specimen,
                const LifeSettings& settings);

/// Cycles, in the last block of `specimen`, at which `p` of all like it have failed.
double quantile_cycles(const LifeSample& sample, LifeSample::Specimen specimen,
                       const LifeSettings& settings, double p);

}  // namespace host_sim::diagnose::lives
