#pragma once

#include <Eigen/Core>

#include "host_sim/diagnose/audit/gram.hpp"

namespace host_sim::diagnose {

/// What varies beside the effects.
struct NoiseModel {
  double sample_sd = 0.01;             ///< of ln T_out - ln T_in of one sample, after whitening
  double session_gain_sd = 0.01;       ///< of the gain of a session, in ln
  double session_friction_sd = 0.006;  ///< of the friction coefficient of a session
};

/// No campaign is better than this: calibration and rounding remain.
inline constexpr NoiseModel kLeastNoise{1e-3, 1e-3, 1e-3};

/// Inner products of all columns of a layout in the metric of the noise, c' V^-1 d, where
/// V = sample_sd^2 I + Z D Z' in each session, Z = [1, -phi s] and D the scatter of sessions. The
/// root of a diagonal element is how many standard deviations a unit of that column makes.
struct Projection {
  Eigen::MatrixXd before;
  Eigen::MatrixXd left;  ///< after the gain and friction of all sessions are projected off too
  /// By column: what of a diagonal element of `left` may be rounding.
  Eigen::VectorXd rounding;
};

/// Sums over sessions in their order, then takes the common gain and friction off. Directions of
/// these that the sessions do not show, to rounding, are left alone.
Projection project(const Grams& grams, const NoiseModel& noise);

}  // namespace host_sim::diagnose
