#include "host_sim/diagnose/tension/scatter_score.hpp"

#include <Eigen/LU>
#include <cmath>

namespace host_sim::diagnose {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// X'V^-1 X of one session times sample_sd^2: `rows` from `first` on, and the first `columns`.
MatrixXd information(const SessionGram& session, const Eigen::Matrix2d& shrinkage, Index first,
                     Index rows, Index columns) {
  return session.gram.block(first, 0, rows, columns) -
         session.gram.block(first, 0, rows, 2) * shrinkage * session.gram.topLeftCorner(2, columns);
}

}  // namespace

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

void ScatterScore::look_at_probes(const Grams& grams) {
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

}  // namespace host_sim::diagnose
