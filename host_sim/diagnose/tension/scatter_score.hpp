#pragma once

#include <Eigen/Core>
#include <vector>

#include "host_sim/diagnose/projection.hpp"

namespace host_sim::diagnose {

/// The inverse of a block of columns' information, by the directions that it has.
struct BlockInverse {
  Eigen::Index first = 0;  ///< of the block, in a score
  Eigen::MatrixXd root;    ///< columns x rank: statistic = |root' score|^2

  [[nodiscard]] double freedom() const { return static_cast<double>(root.cols()); }
  /// score' inverse score, chi-square of freedom() where the score is of noise alone.
  [[nodiscard]] double statistic(const Eigen::VectorXd& score) const;
};

/// Of the `count` columns from `first` on. Directions that hold nothing but rounding are left out.
/// @param left information that is left once other columns are projected off
/// @param before diagonal of the information before that
BlockInverse inverse_of(const Eigen::MatrixXd& left, const Eigen::VectorXd& before,
                        Eigen::Index first, Eigen::Index count);

/// A symmetric matrix's inverse on the directions that it has.
Eigen::MatrixXd pseudo_inverse(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& before);

/// ln of its determinant on these directions, up to a constant of `before`.
double log_pseudo_determinant(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& before);

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
  void prepare_probes(const Grams& grams);

  /// -2 ln of the restricted likelihood of the scatter, up to a constant.
  [[nodiscard]] double deviance(const Grams& grams, const Products& products) const;

  /// Of each probe. @pre prepare_probes()
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

/// The values of the scatter of sessions that the measured campaign makes possible.
class PossibleScatter {
 public:
  /// Of scatter_values() with this sample_sd.
  /// @param grams must outlive this
  /// @param refitted how many columns are, as in ScatterScore
  PossibleScatter(const Grams& grams, double sample_sd, Eigen::Index refitted,
                  const Products& measured);

  /// ScatterScore::deviance() of each value.
  [[nodiscard]] std::vector<double> deviances(const Products& products) const;

  /// Where the deviance is least.
  [[nodiscard]] const ScatterScore& best(const Products& products) const;

  /// The value that a uniform number draws from the posterior of these deviances, under a prior
  /// that is flat over the grid.
  [[nodiscard]] const ScatterScore& drawn(const std::vector<double>& deviances,
                                          double uniform) const;

 private:
  const Grams& grams_;
  std::vector<ScatterScore> scores_;
};

}  // namespace host_sim::diagnose
