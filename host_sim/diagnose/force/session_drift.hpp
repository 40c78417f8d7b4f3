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

/// Of gain and friction that suit each session beside a model, the rarer one, and the chance of
/// either.
SessionDrift drift_of(std::span<const ForceCovariance::Refit> refits);

/// Whether what an effect moves sessions by could be a part of what drifts from each to the next:
/// it does so itself, and beside it less than a tenth of its squares would have to be left.
/// @param with,without what suits each session beside the model, and beside that without the effect
bool may_be_drift(std::span<const ForceCovariance::Refit> with,
                  std::span<const ForceCovariance::Refit> without);

}  // namespace host_sim::diagnose
