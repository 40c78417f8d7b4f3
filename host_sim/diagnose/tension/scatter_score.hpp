#pragma once

#include <Eigen/Core>
#include <vector>

#include "host_sim/diagnose/projection.hpp"
#include "host_sim/diagnose/tension/block_inverse.hpp"

namespace host_sim::diagnose {

/// X'y of responses y.
struct Products {
  std::vector<Eigen::Vector2d> common;  ///< with gain and friction, of each session
  Eigen::VectorXd total;                ///< with all columns but the response, of all sessions
};

/// Score statistics of probes under one value of the scatter of sessions. The columns that are
/// refitted (gain, friction, effects) come first in the layout, then the probes, and the response
/// last. Keeps no reference to the Grams, which each call is given again.
class ScatterScore {
 public:
  /// @param refitted how many columns are
  ScatterScore(const Grams& grams, const NoiseModel& noise, Eigen::Index refitted);

  /// Prepares statistics().
  void look_at_probes(const Grams& grams);

  /// -2 ln of the restricted likelihood of the scatter, up to a constant.
  [[nodiscard]] double deviance(const Grams& grams, const Products& products) const;

  /// Of each probe. @pre look_at_probes()
  [[nodiscard]] std::vector<double> statistics(const Grams& grams, const Products& products) const;

  /// Rank of each probe beside what is refitted.
  [[nodiscard]] double freedom(std::size_t probe) const { return blocks_[probe].freedom(); }

  /// What the effects of the model explain beyond gain and friction, in variances of a sample.
  [[nodiscard]] double explained(const Grams& grams, const Products& products) const;

  [[nodiscard]] const NoiseModel& noise() const { return noise_; }

 private:
  /// X'V^-1 y of the first `rows` columns.
  [[nodiscard]] Eigen::VectorXd whitened(const Grams& grams, const Products& products,
                                         Eigen::Index rows) const;

  NoiseModel noise_;
  Eigen::Index refitted_;
  std::vector<Eigen::Matrix2d> shrinkage_;
  double log_determinant_ = 0;
  Eigen::MatrixXd fixed_inverse_, common_inverse_, others_;
  std::vector<BlockInverse> blocks_;
};

}  // namespace host_sim::diagnose
