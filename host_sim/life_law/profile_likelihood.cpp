#include "host_sim/life_law/profile_likelihood.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "host_sim/life_law/life_likelihood.hpp"
#include "host_sim/life_law/newton.hpp"

namespace host_sim::life_law {
namespace {

constexpr Eigen::Index kLnShape = 2;

}  // namespace

ProfileLikelihood::ProfileLikelihood(const LifeDesign& design, const Quantity& quantity,
                                     const Eigen::Vector3d& best)
    : design_(design),
      quantity_(quantity),
      first_(quantity.dependent() == 0 ? 1 : 0),
      second_(quantity.dependent() == kLnShape ? 1 : kLnShape),
      best_(best),
      best_value_(quantity.value(best)) {
  Expansion expansion;
  expand_log_likelihood(design, best, expansion);
  const Eigen::Matrix3d covariance = Eigen::Matrix3d(-expansion.hessian).inverse();
  const Eigen::Vector3d gradient = quantity.gradient(best);
  const double variance = gradient.dot(covariance * gradient);
  ridge_ = covariance * gradient / variance;
  standard_error_ = std::sqrt(variance);
  best_log_likelihood_ = expansion.value;
}

Eigen::Vector3d ProfileLikelihood::complete(const Eigen::Vector2d& free, double value) const {
  Eigen::Vector3d coefficients = Eigen::Vector3d::Zero();
  coefficients[first_] = free[0];
  coefficients[second_] = free[1];
  const Eigen::Index dependent = quantity_.dependent();
  coefficients[dependent] = (value - quantity_.value(coefficients)) / quantity_.linear()[dependent];
  return coefficients;
}

void ProfileLikelihood::expand(const Eigen::VectorXd& free, double value,
                               Expansion& expansion) const {
  const Eigen::Vector3d coefficients = complete(free, value);
  Expansion full;
  expand_log_likelihood(design_, coefficients, full);

  const Eigen::Index dependent = quantity_.dependent();
  const Eigen::Vector3d slopes = -quantity_.gradient(coefficients) / quantity_.linear()[dependent];
  Eigen::Matrix<double, 3, 2> chain = Eigen::Matrix<double, 3, 2>::Zero();
  chain(first_, 0) = 1;
  chain(second_, 1) = 1;
  chain(dependent, 0) = slopes[first_];
  chain(dependent, 1) = slopes[second_];
  expansion.value = full.value;
  expansion.gradient = chain.transpose() * full.gradient;
  expansion.hessian = chain.transpose() * full.hessian * chain;
  if (second_ == kLnShape) {
    const double bend = quantity_.part(coefficients[kLnShape]).second;
    expansion.hessian(1, 1) -= full.gradient[dependent] * bend / quantity_.linear()[dependent];
  }
}

double ProfileLikelihood::loss(double value) const {
  const Eigen::Vector3d near = best_ + (value - best_value_) * ridge_;
  const Eigen::Vector2d start(near[first_], near[second_]);
  const Maximum maximum =
      maximise([this, value](const Eigen::VectorXd& free,
                             Expansion& expansion) { expand(free, value, expansion); },
               start);
  return std::max(0.0, best_log_likelihood_ - maximum.expansion.value);
}

}  // namespace host_sim::life_law
