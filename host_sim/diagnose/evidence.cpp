#include "host_sim/diagnose/evidence.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace host_sim::diagnose {
namespace {

using Eigen::Index;

constexpr std::size_t kGridPoints = 9;
// What rigs scatter by from session to session. A wider grid would take an effect that differs
// between sessions for scatter.
constexpr double kLeastGain_sd = 3e-4;
constexpr double kMostGain_sd = 0.04;
constexpr double kLeastFriction_sd = 2e-4;
constexpr double kMostFriction_sd = 0.02;

/// Standard deviations of the prior of a coefficient that has an expected value, relative to that:
/// the share of a size that is tried in large steps, and of what is there or is not.
constexpr double kShareOfSize = 0.25;
constexpr double kShareOfAll = 0.1;

/// Of a logarithm of tension, in eight digits: less than that squared is rounding, which may be
/// below zero.
constexpr double kLeastLogTension = 1e-8;

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
  double all = point.left(response, response);
  double explained = 0;
  double occam = 0;
  if (!terms.columns.empty()) {
    const Eigen::Map<const Eigen::VectorXd> sd(terms.prior_sd.data(),
                                               static_cast<Index>(terms.prior_sd.size()));
    const Eigen::Map<const Eigen::VectorXd> mean(terms.prior_mean.data(), sd.size());
    const Eigen::MatrixXd squares = point.left(terms.columns, terms.columns);
    const Eigen::VectorXd products = point.left(terms.columns, response);
    all += mean.dot(squares * mean) - 2 * mean.dot(products);
    const Eigen::VectorXd with = sd.cwiseProduct(products - squares * mean);
    Eigen::MatrixXd inner = sd.asDiagonal() * squares * sd.asDiagonal();
    inner.diagonal().array() += 1;
    const Eigen::LLT<Eigen::MatrixXd> cholesky(inner);
    explained = cholesky.matrixL().solve(with).squaredNorm();
    occam = 2 * Eigen::MatrixXd(cholesky.matrixL()).diagonal().array().log().sum();
  }
  const double left = std::max(
      {all - explained, point.left(response, response) * std::numeric_limits<double>::epsilon(),
       kLeastLogTension * kLeastLogTension * samples});
  return -(point.log_determinants + occam + samples * std::log(left / samples)) / 2;
}

ScatterPoint scatter_point(const Grams& grams, const GramSums& sums, const NoiseModel& noise) {
  Projection projection = project(sums, noise);
  const Eigen::Matrix2d common = projection.before.topLeftCorner<2, 2>();
  ScatterPoint point{.noise = noise, .left = std::move(projection.left)};
  const Eigen::Vector2d sd(noise.session_gain_sd, noise.session_friction_sd);
  for (const SessionGram& session : grams.sessions) {
    const Eigen::Matrix2d gram = session.gram.topLeftCorner<2, 2>();
    const Eigen::Matrix2d added =
        sd.asDiagonal() * gram * sd.asDiagonal() / (noise.sample_sd * noise.sample_sd);
    point.log_determinants += std::log((Eigen::Matrix2d::Identity() + added).determinant());
  }
  point.log_determinants += std::log(std::max(common.determinant(), 1e-300));
  return point;
}

}  // namespace

ScatterPoint scatter_point(const Grams& grams, const NoiseModel& noise) {
  return scatter_point(grams, GramSums(grams), noise);
}

std::vector<NoiseModel> scatter_values() {
  std::vector<NoiseModel> values;
  for (std::size_t i = 0; i < kGridPoints; ++i) {
    for (std::size_t j = 0; j < kGridPoints; ++j) {
      NoiseModel noise;
      noise.session_gain_sd = grid_value(kLeastGain_sd, kMostGain_sd, i);
      noise.session_friction_sd = grid_value(kLeastFriction_sd, kMostFriction_sd, j);
      values.push_back(noise);
    }
  }
  return values;
}

std::vector<ScatterPoint> scatter_grid(const Grams& grams, double sample_sd) {
  const GramSums sums(grams);
  std::vector<ScatterPoint> grid;
  for (NoiseModel noise : scatter_values()) {
    noise.sample_sd = sample_sd;
    grid.push_back(scatter_point(grams, sums, noise));
  }
  return grid;
}

void Terms::append(const Terms& other) {
  columns.insert(columns.end(), other.columns.begin(), other.columns.end());
  prior_mean.insert(prior_mean.end(), other.prior_mean.begin(), other.prior_mean.end());
  prior_sd.insert(prior_sd.end(), other.prior_sd.begin(), other.prior_sd.end());
}

Terms terms_of(const GramLayout::Effect& effect, const GramLayout::Block& block) {
  Terms terms;
  const auto parameters = effect.effect->parameters();
  const bool sized = block.count < parameters.size() && parameters[block.count].scaled_by_share;
  for (std::size_t i = 0; i < block.count; ++i) {
    const effects::Parameter& parameter = parameters[effect.effect->per_pose() ? 0 : i];
    terms.columns.push_back(static_cast<Index>(block.first + i));
    terms.prior_mean.push_back(parameter.expected);
    terms.prior_sd.push_back(parameter.expected == 0
                                 ? parameter.typical
                                 : (sized ? kShareOfSize : kShareOfAll) * parameter.expected);
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
