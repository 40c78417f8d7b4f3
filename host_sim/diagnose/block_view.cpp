#include "host_sim/diagnose/block_view.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>

namespace host_sim::diagnose {
namespace {

using effects::Parameter;
using Eigen::Index;

/// Of the energy before the projection: what is smaller is no direction of its own.
constexpr double kNoDirection = 1e-9;

/// The linear parameter that a column stands for.
const Parameter& parameter_of(const effects::TensionEffect& effect, Index column) {
  return effect.parameters()[effect.per_pose() ? 0 : static_cast<std::size_t>(column)];
}

double bound_of(const Parameter& parameter) {
  return std::max(std::abs(parameter.minimum), std::abs(parameter.maximum));
}

/// Energy of the columns at these sizes, each by itself.
double energy(const Eigen::MatrixXd& matrix, const BlockView& view, const Eigen::VectorXd& sizes) {
  const Eigen::VectorXd diagonal = matrix.diagonal().segment(view.first, view.count);
  return std::max(0.0, diagonal.dot(sizes.cwiseAbs2()));
}

Eigen::MatrixXd base_of(const Eigen::MatrixXd& left, double least) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(left);
  const Index size = left.rows();
  Index kept = 0;
  while (kept < size && solver.eigenvalues()(size - 1 - kept) > least) {
    ++kept;
  }
  return solver.eigenvectors().rightCols(kept) *
         solver.eigenvalues().tail(kept).cwiseSqrt().cwiseInverse().asDiagonal();
}

/// The block of `left` between two views, at the typical sizes.
Eigen::MatrixXd between(const BlockView& one, const BlockView& other, const Eigen::MatrixXd& left) {
  return one.typical.asDiagonal() * left.block(one.first, other.first, one.count, other.count) *
         other.typical.asDiagonal();
}

/// Share of the energy of `one` that the columns of `other` explain.
double imitated(const BlockView& one, const BlockView& other, const Eigen::MatrixXd& cross,
                const Eigen::MatrixXd& left) {
  const double whole = energy(left, one, one.typical);
  return whole > 0 ? (cross * other.base).squaredNorm() / whole : 0;
}

double distance(const std::vector<double>& shape, std::span<const Parameter> parameters) {
  double sum = 0;
  for (std::size_t i = 0; i < shape.size(); ++i) {
    const Parameter& parameter = parameters[parameters.size() - shape.size() + i];
    const double apart = (shape[i] - parameter.typical) / (parameter.maximum - parameter.minimum);
    sum += apart * apart;
  }
  return sum;
}

}  // namespace

BlockView view_of(const GramLayout::Effect& effect, const GramLayout::Block& block,
                  const Projection& projection) {
  BlockView view{.first = static_cast<Index>(block.first),
                 .count = static_cast<Index>(block.count),
                 .typical = {},
                 .base = {}};
  view.typical.resize(view.count);
  Eigen::VectorXd bounds(view.count);
  for (Index column = 0; column < view.count; ++column) {
    const Parameter& parameter = parameter_of(*effect.effect, column);
    view.typical(column) = std::abs(parameter.typical);
    bounds(column) = bound_of(parameter);
  }
  const double before = energy(projection.before, view, view.typical);
  const double left = energy(projection.left, view, view.typical);
  view.share = before > 0 ? std::min(1.0, std::sqrt(left / before)) : 0;
  view.sigmas = std::sqrt(left);
  view.sigmas_at_bound = std::sqrt(energy(projection.left, view, bounds));
  const double rounding =
      projection.rounding.segment(view.first, view.count).dot(view.typical.cwiseAbs2());
  view.base =
      base_of(between(view, view, projection.left), std::max(kNoDirection * before, rounding));
  return view;
}

std::size_t typical_block(const GramLayout::Effect& effect) {
  std::size_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < effect.blocks.size(); ++i) {
    const double apart = distance(effect.blocks[i].shape, effect.effect->parameters());
    if (apart < least) {
      least = apart;
      nearest = i;
    }
  }
  return nearest;
}

Likeness likeness_of(const BlockView& one, const BlockView& other, const Projection& projection) {
  if (one.base.cols() == 0 || other.base.cols() == 0) {
    return {};
  }
  const Eigen::MatrixXd cross = between(one, other, projection.left);
  const double least = std::min(imitated(one, other, cross, projection.left),
                                imitated(other, one, cross.transpose(), projection.left));
  const Eigen::MatrixXd correlations = one.base.transpose() * cross * other.base;
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(correlations);
  return {.cosine = std::sqrt(std::clamp(least, 0.0, 1.0)),
          .canonical = std::min(1.0, svd.singularValues()(0))};
}

}  // namespace host_sim::diagnose
