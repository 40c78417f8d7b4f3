#pragma once

#include <Eigen/Core>
#include <functional>

namespace host_sim::life_law {

/// A function of several variables near a point: value, gradient and Hessian.
struct Expansion {
  double value = 0;
  Eigen::VectorXd gradient;
  Eigen::MatrixXd hessian;

  void reset(Eigen::Index variables) {
    value = 0;
    gradient.setZero(variables);
    hessian.setZero(variables, variables);
  }
};

/// Fills in the expansion at a point; a value that is not finite stands for a point that is out of
/// reach.
using Objective = std::function<void(const Eigen::VectorXd&, Expansion&)>;

struct Maximum {
  Eigen::VectorXd at;
  Expansion expansion;
  bool converged = false;  ///< what a further step would gain is below rounding
};

/// Ascends from `start` by Newton steps, damped where the full step gains too little; where the
/// Hessian is not negative definite, steps follow its eigenvectors uphill.
/// @pre the value at `start` is finite
Maximum maximise(const Objective& objective, const Eigen::VectorXd& start);

}  // namespace host_sim::life_law
