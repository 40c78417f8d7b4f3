#pragma once

#include <Eigen/Core>
#include <span>

#include "host_sim/diagnose/force/force_covariance.hpp"

namespace host_sim::diagnose {

/// Whether values of sessions that follow each other are alike, as what changes slowly makes them:
/// the air of a room, or a sheath that ages.
struct SessionDrift {
  double ratio =
      2;         ///< of squared differences to squares (von Neumann); 2 where they are of chance
  double p = 1;  ///< that chance alone leaves a ratio as small
};

/// @param values of sessions in their order; fewer than 8 show nothing
SessionDrift drift_of(const Eigen::VectorXd& values);

/// Gain and friction that suit each session beside a model, without their means, in standard
/// deviations of what noise and scatter leave them: noise alone makes those of neighbours alike
/// that know little.
/// @param scatter standard deviations of ln gain and friction between sessions
/// @returns of each session ln gain and friction
Eigen::MatrixX2d standardized(std::span<const ForceCovariance::Refit> refits,
                              const Eigen::Array2d& scatter);

/// Of such gain and friction the rarer one, and the chance of either.
SessionDrift drift_of_either(const Eigen::MatrixX2d& sessions);

/// Whether what an effect moves sessions by could be a part of what drifts from each to the next:
/// it does so itself, and beside it less than a tenth of its squares would have to be left.
/// @param with,without what suits each session beside the model, and beside that without the effect
/// @param scatter standard deviations of ln gain and friction between sessions
bool may_be_drift(std::span<const ForceCovariance::Refit> with,
                  std::span<const ForceCovariance::Refit> without, const Eigen::Array2d& scatter);

}  // namespace host_sim::diagnose
