#include "host_sim/diagnose/projection.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

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
/// `scale` is the size of its diagonal before anything was taken off.
Eigen::Matrix2d inverse_of(const Eigen::Matrix2d& matrix, const Eigen::Vector2d& scale,
                           const Eigen::Vector2d& rounding) {
  Eigen::Vector2d unit;
  double least = kSameDirection;
  for (Eigen::Index i = 0; i < 2; ++i) {
    unit(i) = scale(i) > 0 ? 1 / std::sqrt(scale(i)) : 0;
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

/// The inverse of what the scatter of a session adds: D^1/2 (sd^2 I + D^1/2 Z'Z D^1/2)^-1 D^1/2.
Eigen::Matrix2d shrinkage(const Eigen::Matrix2d& gram, const NoiseModel& noise) {
  if (noise.free_sessions) {
    return inverse_of_products(gram);
  }
  const Eigen::Vector2d sd(noise.session_gain_sd, noise.session_friction_sd);
  const Eigen::Matrix2d inner = noise.sample_sd * noise.sample_sd * Eigen::Matrix2d::Identity() +
                                Eigen::Matrix2d(sd.asDiagonal() * gram * sd.asDiagonal());
  return sd.asDiagonal() * inner.inverse() * sd.asDiagonal();
}

/// `matrix` less what its first two columns explain.
Eigen::MatrixXd without_common(const Eigen::MatrixXd& matrix, const Eigen::Matrix2d& inverse) {
  Eigen::MatrixXd left = matrix;
  left.noalias() -= matrix.leftCols<2>() * inverse * matrix.topRows<2>();
  return left;
}

}  // namespace

Eigen::Matrix2d inverse_of_products(const Eigen::Matrix2d& matrix) {
  return inverse_of(matrix, matrix.diagonal(), kRounding * matrix.diagonal());
}

Eigen::MatrixXd session_information(const SessionGram& session, const NoiseModel& noise) {
  const Eigen::Matrix2d common = session.gram.topLeftCorner<2, 2>();
  return without_common(session.gram, shrinkage(common, noise)) /
         (noise.sample_sd * noise.sample_sd);
}

GramSums::GramSums(const Grams& grams) {
  const auto size = static_cast<Eigen::Index>(grams.layout.size());
  total = Eigen::MatrixXd::Zero(size, size);
  common = Eigen::MatrixXd(size, 2 * std::ssize(grams.sessions));
  Eigen::Index place = 0;
  for (const SessionGram& session : grams.sessions) {
    total += session.gram;
    common.middleCols<2>(place) = session.gram.leftCols<2>();
    place += 2;
  }
}

Projection project(const GramSums& sums, const NoiseModel& noise) {
  const double variance = noise.sample_sd * noise.sample_sd;
  Eigen::MatrixXd shrunk(sums.common.rows(), sums.common.cols());
  for (Eigen::Index place = 0; place < sums.common.cols(); place += 2) {
    const Eigen::Matrix2d common = sums.common.block<2, 2>(0, place);
    shrunk.middleCols<2>(place) = sums.common.middleCols<2>(place) * shrinkage(common, noise);
  }
  Eigen::MatrixXd information = sums.total / variance;
  const Eigen::VectorXd plain = information.diagonal();
  Projection projection;
  projection.rounding = kRounding * plain;
  if (noise.free_sessions) {
    projection.before = information;
  }
  information.noalias() -= shrunk * sums.common.transpose() / variance;
  const Eigen::Matrix2d common = information.topLeftCorner<2, 2>();
  const Eigen::Vector2d scale =
      noise.free_sessions ? plain.head<2>() : Eigen::Vector2d(information.diagonal().head<2>());
  projection.left =
      without_common(information, inverse_of(common, scale, projection.rounding.head<2>()));
  if (!noise.free_sessions) {
    projection.before = std::move(information);
  }
  return projection;
}

Projection project(const Grams& grams, const NoiseModel& noise) {
  return project(GramSums(grams), noise);
}

}  // namespace host_sim::diagnose
