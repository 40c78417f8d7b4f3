#include "host_sim/diagnose/projection.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace host_sim::diagnose {
namespace {

/// Of a sum of products over the samples; what differences of such sums leave is no smaller.
constexpr double kRounding = 1e-12;

/// Below this share of the whole two directions are one.
constexpr double kSameDirection = 1e-9;

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
  const Eigen::Matrix2d scaled = unit.asDiagonal() * matrix * unit.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(scaled);
  Eigen::Vector2d inverse = Eigen::Vector2d::Zero();
  for (Eigen::Index i = 0; i < 2; ++i) {
    if (solver.eigenvalues()(i) > least) {
      inverse(i) = 1 / solver.eigenvalues()(i);
    }
  }
  const Eigen::Matrix2d vectors = unit.asDiagonal() * solver.eigenvectors();
  return vectors * inverse.asDiagonal() * vectors.transpose();
}

/// The inverse of what the scatter of a session adds: D^1/2 (sd^2 I + D^1/2 Z'Z D^1/2)^-1 D^1/2.
Eigen::Matrix2d shrinkage(const Eigen::Matrix2d& gram, const NoiseModel& noise) {
  if (noise.free_sessions) {
    return inverse_of(gram, gram.diagonal(), kRounding * gram.diagonal());
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

Eigen::MatrixXd session_information(const SessionGram& session, const NoiseModel& noise) {
  const Eigen::Matrix2d common = session.gram.topLeftCorner<2, 2>();
  return without_common(session.gram, shrinkage(common, noise)) /
         (noise.sample_sd * noise.sample_sd);
}

Projection project(const Grams& grams, const NoiseModel& noise) {
  const auto size = static_cast<Eigen::Index>(grams.layout.size());
  Eigen::MatrixXd plain = Eigen::MatrixXd::Zero(size, size);
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(size, size);
  for (const SessionGram& session : grams.sessions) {
    plain += session.gram / (noise.sample_sd * noise.sample_sd);
    information += session_information(session, noise);
  }
  const Eigen::Matrix2d common = information.topLeftCorner<2, 2>();
  const Eigen::Vector2d scale = (noise.free_sessions ? plain : information).diagonal().head<2>();
  Projection projection;
  projection.rounding = kRounding * plain.diagonal();
  projection.left =
      without_common(information, inverse_of(common, scale, projection.rounding.head<2>()));
  projection.before = noise.free_sessions ? std::move(plain) : std::move(information);
  return projection;
}

}  // namespace host_sim::diagnose
