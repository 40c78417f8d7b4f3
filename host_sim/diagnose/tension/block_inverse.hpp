#pragma once

#include <Eigen/Core>

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

}  // namespace host_sim::diagnose
