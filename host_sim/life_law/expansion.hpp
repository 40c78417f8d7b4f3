#pragma once

#include <Eigen/Core>

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

}  // namespace host_sim::life_law
