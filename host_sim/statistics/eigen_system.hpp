#pragma once

#include <Eigen/Core>

namespace host_sim::statistics {

/// Of a symmetric matrix.
struct EigenSystem {
  Eigen::VectorXd values;   ///< in ascending order
  Eigen::MatrixXd vectors;  ///< of length 1, a column for each value
};

/// Compiled once, because Eigen's own takes a compiler seconds. The lower triangle is read.
EigenSystem eigen_system(const Eigen::MatrixXd& matrix);

}  // namespace host_sim::statistics
