#include "host_sim/life_law/newton.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "host_sim/statistics/eigen_system.hpp"

namespace host_sim::life_law {
namespace {

constexpr int kMaxSteps = 200;
constexpr int kMaxHalvings = 50;
/// No coordinate moves further in one step.
constexpr double kMaxMove = 3;
/// A step that promises less gain is the last: steps converge quadratically, so that what is left
/// after it is below rounding.
constexpr double kLastGain = 1e-13;
/// The least share of the promised gain that a step must keep.
constexpr double kSufficientGain = 1e-4;

/// Units in which the Hessian has ones on its diagonal, so that what is flat does not depend on how
/// steep the rest is.
Eigen::VectorXd units(const Expansion& expansion) {
  return expansion.hessian.diagonal().cwiseAbs().cwiseMax(1.0).cwiseSqrt().cwiseInverse();
}

Eigen::VectorXd uphill_along_eigenvectors(const Expansion& expansion) {
  constexpr double kFlattest = 1e-8;
  const Eigen::VectorXd unit = units(expansion);
  const Eigen::MatrixXd hessian = unit.asDiagonal() * expansion.hessian * unit.asDiagonal();
  const auto [values, vectors] = statistics::eigen_system(hessian);
  const Eigen::VectorXd size = values.cwiseAbs().cwiseMax(kFlattest);
  const Eigen::VectorXd gradient = unit.cwiseProduct(expansion.gradient);
  const Eigen::VectorXd step = vectors * (vectors.transpose() * gradient).cwiseQuotient(size);
  return unit.cwiseProduct(step);
}

Eigen::VectorXd newton_step(const Expansion& expansion) {
  const Eigen::LLT<Eigen::MatrixXd> cholesky(-expansion.hessian);
  if (cholesky.info() == Eigen::Success) {
    return cholesky.solve(expansion.gradient);
  }
  return uphill_along_eigenvectors(expansion);
}

void limit_move(Eigen::VectorXd& step) {
  const double move = step.cwiseAbs().maxCoeff();
  if (move > kMaxMove) {
    step *= kMaxMove / move;
  }
}

/// Moves along `step`, or a part of it that gains enough; false where none does.
bool ascend(const Objective& objective, const Eigen::VectorXd& step, double promised,
            Maximum& current) {
  const double rounding = 1e-14 * (1 + std::abs(current.expansion.value));
  Maximum trial;
  double part = 1;
  for (int halving = 0; halving <= kMaxHalvings; ++halving, part /= 2) {
    trial.at = current.at + part * step;
    objective(trial.at, trial.expansion);
    const double least = current.expansion.value + kSufficientGain * part * promised - rounding;
    if (std::isfinite(trial.expansion.value) && trial.expansion.value >= least) {
      std::swap(current, trial);
      return true;
    }
  }
  return false;
}

}  // namespace

Maximum maximise(const Objective& objective, const Eigen::VectorXd& start) {
  Maximum current{.at = start, .expansion = {}};
  objective(current.at, current.expansion);
  for (int i = 0; i < kMaxSteps; ++i) {
    Eigen::VectorXd step = newton_step(current.expansion);
    limit_move(step);
    const double promised = current.expansion.gradient.dot(step);
    const bool moved = ascend(objective, step, promised, current);
    if (promised < kLastGain) {
      current.converged = true;
      return current;
    }
    if (!moved) {
      return current;
    }
  }
  return current;
}

}  // namespace host_sim::life_law
