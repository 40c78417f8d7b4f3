#include "tests/blind/oracle/session_information.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace blind {
namespace {

/// Rows of samples whose noise is independent and of standard deviation 1. A column of zeros stays.
Eigen::MatrixX3d whitened(const Eigen::MatrixX3d& columns, const Disturbance& disturbance) {
  const double rho = disturbance.ar1;
  Eigen::MatrixX3d white = columns;
  const Eigen::Index last = columns.rows() - 1;
  white.bottomRows(last) -= rho * columns.topRows(last);
  white.bottomRows(last) /= std::sqrt(1 - rho * rho);
  return white / disturbance.noise_sd;
}

}  // namespace

Information session_information(const std::vector<double>& trace,
                                const std::vector<double>& signed_bend_rad,
                                const Disturbance& disturbance) {
  const auto rows = static_cast<Eigen::Index>(trace.size());
  Eigen::MatrixX3d columns(rows, 3);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const auto place = static_cast<std::size_t>(i);
    columns.row(i) << trace[place], 1, -signed_bend_rad[place];
  }
  const Eigen::MatrixX3d white = whitened(columns, disturbance);
  const Information without_scatter = white.transpose() * white;
  // Woodbury: the scatter is that of the coefficients in the last two columns.
  const Eigen::Vector2d variances(disturbance.gain_sd * disturbance.gain_sd,
                                  disturbance.friction_sd * disturbance.friction_sd);
  const Eigen::Matrix<double, 3, 2> cross = without_scatter.rightCols<2>();
  const Eigen::Matrix2d inner =
      Eigen::Matrix2d::Identity() +
      Eigen::Matrix2d(variances.asDiagonal()) * without_scatter.bottomRightCorner<2, 2>();
  return without_scatter -
         cross * inner.inverse() * Eigen::Matrix2d(variances.asDiagonal()) * cross.transpose();
}

double sigmas_of(const Information& information) {
  const Eigen::Matrix2d nuisance = information.bottomRightCorner<2, 2>();
  const Eigen::Vector2d cross = information.block<2, 1>(1, 0);
  const double left = information(0, 0) - cross.dot(nuisance.inverse() * cross);
  return std::sqrt(std::max(0.0, left));
}

}  // namespace blind
