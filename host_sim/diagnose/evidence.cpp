#include "host_sim/diagnose/evidence.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

namespace host_sim::diagnose {
namespace {

using Eigen::Index;

constexpr std::size_t kGridPoints = 9;
constexpr double kLeastGain_sd = 3e-4;
constexpr double kMostGain_sd = 0.1;
constexpr double kLeastFriction_sd = 2e-4;
constexpr double kMostFriction_sd = 0.06;

double grid_value(double least, double most, std::size_t i) {
  return least * std::pow(most / least, static_cast<double>(i) / (kGridPoints - 1.0));
}

double log_sum_exp(const std::vector<double>& values) {
  const double most = *std::max_element(values.begin(), values.end());
  double sum = 0;
  for (const double value : values) {
    sum += std::exp(value - most);
  }
  return most + std::log(sum);
}

double log_evidence_at(const ScatterPoint& point, const Terms& terms, Index response,
                       double samples) {
  const double all = point.left(response, response);
  double explained = 0;
  double occam = 0;
  if (!terms.columns.empty()) {
    const auto count = static_cast<Index>(terms.columns.size());
    Eigen::MatrixXd inner(count, count);
    Eigen::VectorXd with(count);
    for (Index i = 0; i < count; ++i) {
      const auto at = static_cast<std::size_t>(i);
      with(i) = point.left(terms.columns[at], response) * terms.prior_sd[at];
      for (Index j = 0; j < count; ++j) {
        const auto other = static_cast<std::size_t>(j);
        inner(i, j) = point.left(terms.columns[at], terms.columns[other]) * terms.prior_sd[at] *
                      terms.prior_sd[other];
      }
    }
    inner.diagonal().array() += 1;
    const Eigen::LLT<Eigen::MatrixXd> cholesky(inner);
    explained = cholesky.matrixL().solve(with).squaredNorm();
    occam = 2 * Eigen::MatrixXd(cholesky.matrixL()).diagonal().array().log().sum();
  }
  const double left = std::max(all - explained, all * std::numeric_limits<double>::epsilon());
  return -(point.log_determinants + occam + samples * std::log(left / samples)) / 2;
}

}  // namespace

ScatterPoint scatter_point(const Grams& grams, const NoiseModel& noise) {
  ScatterPoint point{.noise = noise, .left = project(grams, noise).left};
  const Eigen::Vector2d sd(noise.session_gain_sd, noise.session_friction_sd);
  Eigen::Matrix2d common = Eigen::Matrix2d::Zero();
  for (const SessionGram& session : grams.sessions) {
    const Eigen::Matrix2d gram = session.gram.topLeftCorner<2, 2>();
    const Eigen::Matrix2d added =
        sd.asDiagonal() * gram * sd.asDiagonal() / (noise.sample_sd * noise.sample_sd);
    point.log_determinants += std::log((Eigen::Matrix2d::Identity() + added).determinant());
    common += session_information(session, noise).topLeftCorner<2, 2>();
  }
  point.log_determinants += std::log(std::max(common.determinant(), 1e-300));
  return point;
}

std::vector<ScatterPoint> scatter_grid(const Grams& grams, double sample_sd) {
  std::vector<ScatterPoint> grid;
  for (std::size_t i = 0; i < kGridPoints; ++i) {
    for (std::size_t j = 0; j < kGridPoints; ++j) {
      NoiseModel noise{.sample_sd = sample_sd};
      noise.session_gain_sd = grid_value(kLeastGain_sd, kMostGain_sd, i);
      noise.session_friction_sd = grid_value(kLeastFriction_sd, kMostFriction_sd, j);
      grid.push_back(scatter_point(grams, noise));
    }
  }
  return grid;
}

Terms terms_of(const GramLayout::Effect& effect, const GramLayout::Block& block) {
  Terms terms;
  const auto parameters = effect.effect->parameters();
  for (std::size_t i = 0; i < block.count; ++i) {
    const effects::Parameter& parameter = parameters[effect.effect->per_pose() ? 0 : i];
    terms.columns.push_back(static_cast<Index>(block.first + i));
    terms.prior_sd.push_back(parameter.typical);
  }
  return terms;
}

double log_evidence(const std::vector<ScatterPoint>& grid, const Terms& terms, Index response,
                    double samples) {
  std::vector<double> values;
  values.reserve(grid.size());
  for (const ScatterPoint& point : grid) {
    values.push_back(log_evidence_at(point, terms, response, samples));
  }
  return log_sum_exp(values) - std::log(static_cast<double>(grid.size()));
}

}  // namespace host_sim::diagnose
