#pragma once

#include <Eigen/Core>

#include "host_sim/life_law/life_fit.hpp"
#include "host_sim/life_law/log_tension_frame.hpp"

namespace host_sim::life_law {

/// A quantity of a power law with one shape as a function of the coefficients of its design
/// (ln alpha at the centre, exponent times spread, phi = ln beta):
///   q = linear . coefficients + h(phi)
/// where h is 0, sigma ln(-ln(1 - p)) for a quantile, ln Gamma(1 + sigma) for a mean life, with
/// sigma = exp(-phi). The shape is taken by its logarithm.
class Quantity {
 public:
  Quantity(const LifeQuantity& wanted, const LogTensionFrame& frame);

  /// What follows from ln beta, and its derivatives.
  struct Part {
    double value = 0, first = 0, second = 0;
  };
  [[nodiscard]] Part part(double ln_shape) const;

  [[nodiscard]] double value(const Eigen::Vector3d& coefficients) const;
  [[nodiscard]] Eigen::Vector3d gradient(const Eigen::Vector3d& coefficients) const;
  [[nodiscard]] const Eigen::Vector3d& linear() const { return linear_; }

  /// The coefficient that is given by the quantity and the other two.
  [[nodiscard]] Eigen::Index dependent() const { return dependent_; }

 private:
  LifeQuantity::Kind kind_;
  double p_;
  Eigen::Vector3d linear_;
  Eigen::Index dependent_;
};

}  // namespace host_sim::life_law
