#pragma once

#include <Eigen/Core>

namespace host_sim::diagnose::lives {

/// Columns over specimens in the metric of their information, once A and gamma are refitted.
class LifeProjection {
 public:
  /// @param ln_tension of each specimen
  /// @param weights information of each specimen on its ln alpha
  LifeProjection(const Eigen::VectorXd& ln_tension, const Eigen::VectorXd& weights);

  /// Each column in units of the standard deviation of its specimens.
  [[nodiscard]] Eigen::MatrixXd scaled(const Eigen::MatrixXd& columns) const;
  /// The same, less what A and gamma take of it.
  [[nodiscard]] Eigen::MatrixXd left(const Eigen::MatrixXd& columns) const;

 private:
  Eigen::VectorXd roots_;
  Eigen::MatrixXd base_;  ///< orthonormal, of A and gamma
};

/// Root of the share of the energy of `column` that is in the space of `others`: |cos| for one.
double imitated(const Eigen::VectorXd& column, const Eigen::MatrixXd& others);

}  // namespace host_sim::diagnose::lives
