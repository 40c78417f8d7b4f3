#pragma once

#include <Eigen/Core>
#include <functional>

#include "host_sim/life_law/expansion.hpp"

namespace host_sim::life_law {

/// Fills in the expansion at a point; a value that is not finite stands for a point that is out of
/// reach.
using Objective = std::function<void(const Eigen::VectorXd&, Expansion&)>;

struct Maximum {
  Eigen::VectorXd at;
  Expansion expansion;
  bool converged = false;  ///< what a further step would gain is below rounding
};

/// Climbs from `start` by Newton steps, damped where the full step gains too little; where the
/// Hessian is not negative definite, steps follow its eigenvectors uphill.
/// @pre the value at `start` is finite
Maximum maximise(const Objective& objective, const Eigen::VectorXd& start);

}  // namespace host_sim::life_law
