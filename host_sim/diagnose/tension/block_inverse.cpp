#include "host_sim/diagnose/tension/block_inverse.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <vector>

namespace host_sim::diagnose {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kSameDirection = 1e-7;  ///< of the energy of a column before the projection

}  // namespace

double BlockInverse::statistic(const VectorXd& score) const {
  return root.cols() == 0 ? 0
                          : (root.transpose() * score.segment(first, root.rows())).squaredNorm();
}

BlockInverse inverse_of(const MatrixXd& left, const VectorXd& before, Index first, Index count) {
  const VectorXd unit = before.segment(first, count).cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(
      unit.asDiagonal() * left.block(first, first, count, count) * unit.asDiagonal());
  std::vector<Index> kept;
  for (Index i = 0; i < count; ++i) {
    if (solver.eigenvalues()(i) > kSameDirection) {
      kept.push_back(i);
    }
  }
  BlockInverse inverse{.first = first, .root = MatrixXd(count, static_cast<Index>(kept.size()))};
  for (Index i = 0; i < inverse.root.cols(); ++i) {
    const Index from = kept[static_cast<std::size_t>(i)];
    inverse.root.col(i) =
        unit.asDiagonal() * solver.eigenvectors().col(from) / std::sqrt(solver.eigenvalues()(from));
  }
  return inverse;
}

MatrixXd pseudo_inverse(const MatrixXd& matrix, const VectorXd& before) {
  const BlockInverse inverse = inverse_of(matrix, before, 0, matrix.rows());
  return inverse.root * inverse.root.transpose();
}

double log_pseudo_determinant(const MatrixXd& matrix, const VectorXd& before) {
  const BlockInverse inverse = inverse_of(matrix, before, 0, matrix.rows());
  const MatrixXd scaled = before.cwiseSqrt().asDiagonal() * inverse.root;
  double sum = 0;
  for (Index i = 0; i < scaled.cols(); ++i) {
    sum -= std::log(scaled.col(i).squaredNorm());
  }
  return sum;
}

}  // namespace host_sim::diagnose
