#pragma once

#include <cmath>
#include <cstddef>

#include "host_sim/effects/tension_effect.hpp"

namespace host_sim::effects {

/// Whether the tendon turns between the sample before and this one.
inline bool turns_at(const recording::Covariates& covariates, std::size_t i) {
  return i > 0 && covariates.direction[i] != covariates.direction[i - 1];
}

/// When within the step to sample i the motion turned, as a share of the step: where the velocity,
/// taken as linear, is zero.
inline double turned_at(const recording::Covariates& covariates, std::size_t i) {
  const double before = std::abs(covariates.velocity_m_s[i - 1]);
  const double after = std::abs(covariates.velocity_m_s[i]);
  return before + after > 0 ? before / (before + after) : 0.5;
}

/// The friction that a reversal turns over: of the recording by itself where that is known, as its
/// jumps do not follow what a session's friction is off by along the way.
inline double friction_at_reversals(const recording::Covariates& covariates,
                                    const Baseline& baseline) {
  constexpr double kMostFactor = 4;
  const double found = covariates.settled_friction;
  const double nominal = baseline.friction_coefficient;
  return found > nominal / kMostFactor && found < nominal * kMostFactor ? found : nominal;
}

}  // namespace host_sim::effects
