#include "host_sim/diagnose/lives/projection.hpp"

#include <Eigen/QR>
#include <cmath>

namespace host_sim::diagnose::lives {
namespace {

/// Orthonormal base of the columns; those that depend on others to rounding add nothing.
Eigen::MatrixXd base_of(const Eigen::MatrixXd& columns) {
  constexpr double kRounding = 1e-9;
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(columns);
  qr.setThreshold(kRounding);
  const Eigen::Index rank = qr.rank();
  return qr.householderQ() * Eigen::MatrixXd::Identity(columns.rows(), rank);
}

}  // namespace

LifeProjection::LifeProjection(const Eigen::VectorXd& ln_tension, const Eigen::VectorXd& weights)
    : roots_(weights.cwiseSqrt()) {
  Eigen::MatrixXd law(ln_tension.size(), 2);
  law.col(0).setOnes();
  law.col(1) = ln_tension.array() - ln_tension.mean();
  base_ = base_of(scaled(law));
}

Eigen::MatrixXd LifeProjection::scaled(const Eigen::MatrixXd& columns) const {
  return roots_.asDiagonal() * columns;
}

Eigen::MatrixXd LifeProjection::left(const Eigen::MatrixXd& columns) const {
  const Eigen::MatrixXd all = scaled(columns);
  return all - base_ * (base_.transpose() * all);
}

double imitated(const Eigen::VectorXd& column, const Eigen::MatrixXd& others) {
  constexpr double kNothing = 1e-12;
  if (column.norm() < kNothing || others.norm() < kNothing) {
    return 0;
  }
  const Eigen::MatrixXd base = base_of(others);
  return (base.transpose() * column).norm() / column.norm();
}

}  // namespace host_sim::diagnose::lives
