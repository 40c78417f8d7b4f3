#pragma once

#include <span>

#include "host_sim/diagnose/tension/sample_weights.hpp"

namespace host_sim::diagnose {

/// What is left in the samples when each session has every effect of the catalogue, in every shape,
/// to itself: more than any model explains.
struct SampleNoise {
  SampleWeights weights;       ///< one over the variance of a sample, of mean 1
  double autocorrelation = 0;  ///< of first order, once weighed; median of the sessions
  double sample_sd = 0;        ///< of the innovations, of ln T_out - ln T_in
};

/// Noise of slower decay than first order counts by its variance at low frequency.
/// @param wanted the effects and shapes that each session is fitted with
SampleNoise sample_noise(std::span<const Session> sessions, const effects::Baseline& baseline,
                         const std::vector<Wanted>& wanted, unsigned threads);

}  // namespace host_sim::diagnose
