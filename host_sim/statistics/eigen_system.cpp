#include "host_sim/statistics/eigen_system.hpp"

#include <Eigen/Eigenvalues>

namespace host_sim::statistics {

EigenSystem eigen_system(const Eigen::MatrixXd& matrix) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
  return {.values = solver.eigenvalues(), .vectors = solver.eigenvectors()};
}

}  // namespace host_sim::statistics
