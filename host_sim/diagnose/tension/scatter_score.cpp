#include "host_sim/diagnose/tension/scatter_score.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

#include "host_sim/diagnose/evidence.hpp"
#include "host_sim/statistics/eigen_system.hpp"

namespace host_sim::diagnose {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kSameDirection = 1e-7;  ///< of the energy of a column before the projection

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// X'V^-1 X of one session times sample_sd^2: `rows` from `first` on, and the first `columns`.
MatrixXd information(const SessionGram& session, const Eigen::Matrix2d& shrinkage, Index first,
                     Index rows, Index columns) {
  return session.gram.block(first, 0, rows, columns) -
         session.gram.block(first, 0, rows, 2) * shrinkage * session.gram.topLeftCorner(2, columns);
}

constexpr double kImpossible = 14;  ///< of -2 ln likelihood, above the least

}  // namespace

double BlockInverse::statistic(const VectorXd& score) const {
  return root.cols() == 0 ? 0
                          : (root.transpose() * score.segment(first, root.rows())).squaredNorm();
}

BlockInverse inverse_of(const MatrixXd& left, const VectorXd& before, Index first, Index count) {
  const VectorXd unit = before.segment(first, count).cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const auto [values, vectors] = statistics::eigen_system(
      unit.asDiagonal() * left.block(first, first, count, count) * unit.asDiagonal());
  std::vector<Index> kept;
  for (Index i = 0; i < count; ++i) {
    if (values(i) > kSameDirection) {
      kept.push_back(i);
    }
  }
  BlockInverse inverse{.first = first, .root = MatrixXd(count, static_cast<Index>(kept.size()))};
  for (Index i = 0; i < inverse.root.cols(); ++i) {
    const Index from = kept[static_cast<std::size_t>(i)];
    inverse.root.col(i) = unit.asDiagonal() * vectors.col(from) / std::sqrt(values(from));
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

ScatterScore::ScatterScore(const Grams& grams, const NoiseModel& noise, Index refitted)
    : noise_(noise), refitted_(refitted) {
  const Eigen::Vector2d sd(noise.session_gain_sd, noise.session_friction_sd);
  const double variance = noise.sample_sd * noise.sample_sd;
  MatrixXd plain = MatrixXd::Zero(refitted, refitted);
  MatrixXd fixed = MatrixXd::Zero(refitted, refitted);
  for (const SessionGram& session : grams.sessions) {
    const Eigen::Matrix2d gram = session.gram.topLeftCorner<2, 2>();
    const Eigen::Matrix2d inner = variance * Eigen::Matrix2d::Identity() +
                                  Eigen::Matrix2d(sd.asDiagonal() * gram * sd.asDiagonal());
    shrinkage_.push_back(sd.asDiagonal() * inner.inverse() * sd.asDiagonal());
    log_determinant_ += std::log(inner.determinant() / (variance * variance));
    plain += session.gram.topLeftCorner(refitted, refitted);
    fixed += information(session, shrinkage_.back(), 0, refitted, refitted);
  }
  fixed /= variance;
  const VectorXd before = plain.diagonal() / variance;
  fixed_inverse_ = pseudo_inverse(fixed, before);
  common_inverse_ = pseudo_inverse(fixed.topLeftCorner<2, 2>(), before.head<2>());
  log_determinant_ += log_pseudo_determinant(fixed, before);
}

void ScatterScore::prepare_probes(const Grams& grams) {
  const Index size = grams.response() - refitted_;
  const double variance = noise_.sample_sd * noise_.sample_sd;
  VectorXd before = VectorXd::Zero(size);
  MatrixXd rows = MatrixXd::Zero(size, refitted_ + size);
  for (std::size_t i = 0; i < shrinkage_.size(); ++i) {
    before += grams.sessions[i].gram.diagonal().segment(refitted_, size) / variance;
    rows += information(grams.sessions[i], shrinkage_[i], refitted_, size, refitted_ + size);
  }
  rows /= variance;
  others_ = rows.leftCols(refitted_) * fixed_inverse_;
  const MatrixXd left = rows.rightCols(size) - others_ * rows.leftCols(refitted_).transpose();
  for (const GramLayout::ProbeBlock& probe : grams.layout.probes) {
    blocks_.push_back(inverse_of(left, before, static_cast<Index>(probe.first) - refitted_,
                                 static_cast<Index>(probe.probe.columns())));
  }
}

VectorXd ScatterScore::whitened(const Grams& grams, const Products& products, Index rows) const {
  VectorXd sum = products.total.head(rows);
  for (std::size_t i = 0; i < shrinkage_.size(); ++i) {
    sum.noalias() -=
        grams.sessions[i].gram.topLeftCorner(rows, 2) * (shrinkage_[i] * products.common[i]);
  }
  return sum / (noise_.sample_sd * noise_.sample_sd);
}

double ScatterScore::deviance(const Grams& grams, const Products& products) const {
  double saved = 0;
  for (std::size_t i = 0; i < shrinkage_.size(); ++i) {
    saved += products.common[i].dot(shrinkage_[i] * products.common[i]);
  }
  saved /= noise_.sample_sd * noise_.sample_sd;
  const VectorXd fixed = whitened(grams, products, refitted_);
  return log_determinant_ - saved - fixed.dot(fixed_inverse_ * fixed);
}

std::vector<double> ScatterScore::statistics(const Grams& grams, const Products& products) const {
  const VectorXd all = whitened(grams, products, static_cast<Index>(grams.layout.size()) - 1);
  const VectorXd score = all.tail(all.size() - refitted_) - others_ * all.head(refitted_);
  std::vector<double> statistics;
  for (const BlockInverse& block : blocks_) {
    statistics.push_back(block.statistic(score));
  }
  return statistics;
}

double ScatterScore::explained(const Grams& grams, const Products& products) const {
  const VectorXd fixed = whitened(grams, products, refitted_);
  const Eigen::Vector2d common = fixed.head<2>();
  return fixed.dot(fixed_inverse_ * fixed) - common.dot(common_inverse_ * common);
}

PossibleScatter::PossibleScatter(const Grams& grams, double sample_sd, Eigen::Index refitted,
                                 const Products& measured)
    : grams_(grams) {
  for (NoiseModel noise : scatter_values()) {
    noise.sample_sd = sample_sd;
    scores_.emplace_back(grams, noise, refitted);
  }
  const std::vector<double> all = deviances(measured);
  const double least = std::ranges::min(all);
  std::vector<ScatterScore> possible;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i] <= least + kImpossible) {
      possible.push_back(std::move(scores_[i]));
      possible.back().prepare_probes(grams);
    }
  }
  scores_ = std::move(possible);
}

std::vector<double> PossibleScatter::deviances(const Products& products) const {
  std::vector<double> deviances;
  for (const ScatterScore& score : scores_) {
    deviances.push_back(score.deviance(grams_, products));
  }
  return deviances;
}

const ScatterScore& PossibleScatter::best(const Products& products) const {
  const std::vector<double> all = deviances(products);
  return scores_[static_cast<std::size_t>(std::ranges::min_element(all) - all.begin())];
}

const ScatterScore& PossibleScatter::drawn(const std::vector<double>& deviances,
                                           double uniform) const {
  const double least = std::ranges::min(deviances);
  double sum = 0;
  for (const double deviance : deviances) {
    sum += std::exp((least - deviance) / 2);
  }
  double rest = uniform * sum;
  for (std::size_t i = 0; i < deviances.size(); ++i) {
    rest -= std::exp((least - deviances[i]) / 2);
    if (rest <= 0) {
      return scores_[i];
    }
  }
  return scores_.back();
}

}  // namespace host_sim::diagnose
