#pragma once

#include <Eigen/Core>

#include "host_sim/life_law/expansion.hpp"
#include "host_sim/life_law/life_design.hpp"
#include "host_sim/life_law/quantity.hpp"

namespace host_sim::life_law {

/// The largest log likelihood for each value of a quantity.
class ProfileLikelihood {
 public:
  /// @param best coefficients with the largest log likelihood of all
  ProfileLikelihood(const LifeDesign& design, const Quantity& quantity,
                    const Eigen::Vector3d& best);

  [[nodiscard]] double best_value() const { return best_value_; }
  /// Standard error of the quantity by the curvature at its best value.
  [[nodiscard]] double standard_error() const { return standard_error_; }
  /// The log likelihood's loss against its maximum, 0 or more.
  [[nodiscard]] double loss(double value) const;

 private:
  [[nodiscard]] Eigen::Vector3d complete(const Eigen::Vector2d& free, double value) const;
  void expand(const Eigen::VectorXd& free, double value, Expansion& expansion) const;

  const LifeDesign& design_;
  const Quantity& quantity_;
  Eigen::Index first_;  ///< the coefficients that are free
  Eigen::Index second_;
  Eigen::Vector3d best_;
  Eigen::Vector3d
      ridge_;  ///< how the best coefficients move with the quantity, near its best value
  double best_value_;
  double standard_error_;
  double best_log_likelihood_;
};

}  // namespace host_sim::life_law
