#include "host_sim/diagnose/audit/projection.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace host_sim::diagnose {
namespace {

/// Of a sum of products over the samples; what differences of such sums leave is no smaller.
constexpr double kRounding = 1e-12;

/// Below this share of the whole two directions are one.
constexpr double kSameDirection = 1e-9;

/// A symmetric matrix is vectors * diag(values) * vectors'.
struct EigenSystem2 {
  Eigen::Vector2d values;
  Eigen::Matrix2d vectors;
};

/// By one rotation: Golub and Van Loan, Matrix Computations, 4th ed., 8.5.2.
EigenSystem2 eigen_system(const Eigen::Matrix2d& matrix) {
  const double across = matrix(1, 0);
  if (across == 0) {
    return {.values = matrix.diagonal(), .vectors = Eigen::Matrix2d::Identity()};
  }
  const double tau = (matrix(1, 1) - matrix(0, 0)) / (2 * across);
  const double tangent = std::copysign(1.0, tau) / (std::abs(tau) + std::hypot(1.0, tau));
  const double cosine = 1 / std::hypot(1.0, tangent);
  const double sine = tangent * cosine;
  EigenSystem2 system;
  system.values << matrix(0, 0) - tangent * across, matrix(1, 1) + tangent * across;
  system.vectors << cosine, sine, -sine, cosine;
  return system;
}

/// A generalised inverse of a symmetric matrix that is positive but for `rounding` of its diagonal.
Eigen::Matrix2d inverse_of(const Eigen::Matrix2d& matrix, const Eigen::Vector2d& rounding) {
  Eigen::Vector2d unit;
  double least = kSameDirection;
  for (Eigen::Index i = 0; i < 2; ++i) {
    unit(i) = matrix(i, i) > 0 ? 1 / std::sqrt(matrix(i, i)) : 0;
    least = std::max(least, rounding(i) * unit(i) * unit(i));
  }
  const EigenSystem2 system = eigen_system(unit.asDiagonal() * matrix * unit.asDiagonal());
  Eigen::Vector2d inverse = Eigen::Vector2d::Zero();
  for (Eigen::Index i = 0; i < 2; ++i) {
    if (system.values(i) > least) {
      inverse(i) = 1 / system.values(i);
    }
  }
  const Eigen::Matrix2d vectors = unit.asDiagonal() * system.vectors;
  return vectors * inverse.asDiagonal() * vectors.transpose();
}

/// The inverse of what the scatter of a session adds: D^1/2 (I + D^1/2 Z'Z D^1/2)^-1 D^1/2.
Eigen::Matrix2d shrinkage(const Eigen::Matrix2d& gram, const NoiseModel& noise) {
  const Eigen::Vector2d sd(noise.session_gain_sd, noise.session_friction_sd);
  const Eigen::Matrix2d inner =
      Eigen::Matrix2d::Identity() + Eigen::Matrix2d(sd.asDiagonal() * gram * sd.asDiagonal());
  return sd.asDiagonal() * inner.inverse() * sd.asDiagonal();
}

/// `matrix` less what its first two columns explain.
Eigen::MatrixXd without_common(const Eigen::MatrixXd& matrix, const Eigen::Matrix2d& inverse) {
  Eigen::MatrixXd left = matrix;
  left.noalias() -= matrix.leftCols<2>() * inverse * matrix.topRows<2>();
  return left;
}

}  // namespace

Projection project(const Grams& grams, const NoiseModel& noise) {
  const auto size = static_cast<Eigen::Index>(grams.layout.size);
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(size, size);
  // The first two columns of all sessions side by side, so that it is one product.
  Eigen::MatrixXd shared(size, 2 * std::ssize(grams.sessions));
  Eigen::MatrixXd shrunk(shared.rows(), shared.cols());
  Eigen::Index place = 0;
  for (const Eigen::MatrixXd& gram : grams.sessions) {
    information += gram;
    shared.middleCols<2>(place) = gram.leftCols<2>();
    shrunk.middleCols<2>(place) = gram.leftCols<2>() * shrinkage(gram.topLeftCorner<2, 2>(), noise);
    place += 2;
  }
  Projection projection;
  projection.rounding = kRounding * information.diagonal();
  information.noalias() -= shrunk * shared.transpose();
  const Eigen::Matrix2d common = information.topLeftCorner<2, 2>();
  projection.left = without_common(information, inverse_of(common, projection.rounding.head<2>()));
  projection.before = std::move(information);
  return projection;
}

}  // namespace host_sim::diagnose
