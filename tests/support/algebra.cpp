#include "tests/support/algebra.hpp"

#include <Eigen/LU>
#include <Eigen/QR>

namespace host_sim::algebra {

Eigen::MatrixXd inverse(const Eigen::MatrixXd& matrix) {
  return matrix.inverse();
}

Eigen::MatrixXd solved(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right) {
  return matrix.partialPivLu().solve(right);
}

double determinant(const Eigen::MatrixXd& matrix) {
  return matrix.determinant();
}

Eigen::MatrixXd left_by(const Eigen::MatrixXd& columns, const Eigen::MatrixXd& right) {
  const Eigen::MatrixXd factors = columns.colPivHouseholderQr().solve(right);
  return right - columns * factors;
}

}  // namespace host_sim::algebra
