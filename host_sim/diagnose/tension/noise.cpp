#include "host_sim/diagnose/tension/noise.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <vector>

#include "host_sim/statistics/parallel.hpp"

namespace host_sim::diagnose {
namespace {

using Eigen::Index;

constexpr double kRidge = 1e-9;  ///< columns of a session are often alike
constexpr double kMostCorrelation = 0.995;
constexpr double kLeastCorrelation = -0.5;
constexpr double kLeast_sd = 1e-6;
constexpr Index kLags = 40;  ///< of what is left after whitening

Eigen::VectorXd residual_of(const Eigen::MatrixXd& columns) {
  const Index last = columns.cols() - 1;
  const auto terms = columns.leftCols(last);
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(last, last);
  gram.selfadjointView<Eigen::Lower>().rankUpdate(terms.transpose());
  const Eigen::VectorXd unit = gram.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  gram = unit.asDiagonal() * gram * unit.asDiagonal();
  gram.diagonal().array() += kRidge;
  const Eigen::VectorXd product = unit.asDiagonal() * (terms.transpose() * columns.col(last));
  const Eigen::VectorXd solved = gram.selfadjointView<Eigen::Lower>().ldlt().solve(product);
  return columns.col(last) - terms * (unit.asDiagonal() * solved);
}

double lag_product(const Eigen::VectorXd& values, Index lag) {
  const Index rest = values.size() - lag;
  return rest <= 0 ? 0 : values.tail(rest).dot(values.head(rest));
}

/// By session, each with everything to itself; weighed where there are weights.
std::vector<Eigen::VectorXd> residuals_of(std::span<const Session> sessions,
                                          const GramLayout& layout,
                                          const effects::Baseline& baseline,
                                          const SampleWeights& weights, unsigned threads) {
  std::vector<Eigen::VectorXd> residuals(sessions.size());
  statistics::parallel_for(
      sessions.size(),
      [&](std::size_t i) {
        Eigen::MatrixXd columns = columns_of(sessions[i], layout, baseline);
        if (!weights.empty()) {
          weigh(columns, weights[i]);
        }
        residuals[i] = residual_of(columns);
      },
      threads);
  return residuals;
}

/// Variance of sums over that of samples, of values that should be white; at least 1.
double long_run_ratio(const std::vector<Eigen::VectorXd>& residuals, double autocorrelation) {
  std::vector<double> products(kLags + 1, 0.0);
  for (const Eigen::VectorXd& residual : residuals) {
    const Index rest = residual.size() - 1;
    const Eigen::VectorXd white = residual.tail(rest) - autocorrelation * residual.head(rest);
    for (Index lag = 0; lag <= kLags; ++lag) {
      products[static_cast<std::size_t>(lag)] += lag_product(white, lag);
    }
  }
  double ratio = 1;
  if (products.front() <= 0) {
    return ratio;
  }
  for (Index lag = 1; lag <= kLags; ++lag) {
    const double taper = 1 - static_cast<double>(lag) / (kLags + 1.0);
    ratio += 2 * taper * products[static_cast<std::size_t>(lag)] / products.front();
  }
  return std::max(ratio, 1.0);
}

}  // namespace

SampleNoise sample_noise(std::span<const Session> sessions, const effects::Baseline& baseline,
                         const std::vector<Wanted>& wanted, unsigned threads) {
  const GramLayout layout = layout_of(sessions, baseline, wanted);
  SampleNoise noise;
  std::vector<Eigen::VectorXd> residuals = residuals_of(sessions, layout, baseline, {}, threads);
  noise.weights = sample_weights(sessions, residuals);
  if (!noise.weights.empty()) {
    residuals = residuals_of(sessions, layout, baseline, noise.weights, threads);
  }
  std::vector<double> correlations;
  for (const Eigen::VectorXd& residual : residuals) {
    const double energy = residual.squaredNorm();
    correlations.push_back(energy > 0 ? lag_product(residual, 1) / energy : 0);
  }
  std::ranges::nth_element(correlations, correlations.begin() + std::ssize(correlations) / 2);
  noise.autocorrelation =
      std::clamp(correlations[correlations.size() / 2], kLeastCorrelation, kMostCorrelation);
  double energy = 0;
  double freedom = 0;
  for (const Eigen::VectorXd& residual : residuals) {
    const Index rest = residual.size() - 1;
    energy += (residual.tail(rest) - noise.autocorrelation * residual.head(rest)).squaredNorm();
    freedom += std::max(static_cast<double>(residual.size()) - static_cast<double>(layout.size()),
                        static_cast<double>(residual.size()) / 10);
  }
  const double variance = energy / freedom * long_run_ratio(residuals, noise.autocorrelation);
  noise.sample_sd = std::max(std::sqrt(variance), kLeast_sd);
  return noise;
}

}  // namespace host_sim::diagnose
