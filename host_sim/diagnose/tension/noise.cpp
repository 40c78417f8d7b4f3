#include "host_sim/diagnose/tension/noise.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "host_sim/statistics/parallel.hpp"

namespace host_sim::diagnose {
namespace {

constexpr double kLeast_c = 1e-3;
constexpr double kStep = 1.9952623149688795;  ///< from one c to the next: 10^0.3
constexpr int kLadderSteps = 30;

/// ln of the likelihood ratio for each sample that is not worth the trouble of weights.
constexpr double kLeastGain = 0.005;

/// A session is no quieter than by this share of the variance of all.
constexpr double kLeastOfMean = 0.01;

/// What the variance of each sample goes with beside what is the same for all of a session.
std::vector<double> variances_of(const recording::Covariates& covariates) {
  std::vector<double> variances;
  for (std::size_t i = 0; i < covariates.samples(); ++i) {
    if (!covariates.input_noise.empty()) {
      variances.push_back(covariates.input_noise[i] + covariates.output_noise[i]);
      continue;
    }
    const double input_N = covariates.tension_in_N()[i];
    const double output_N = covariates.output_tension_N[i];
    variances.push_back(1 / (input_N * input_N) + 1 / (output_N * output_N));
  }
  return variances;
}

/// A session by what it is weighed by.
struct Spread {
  std::vector<double> variances;
  const Eigen::VectorXd& residual;

  /// a^2 of the session at its best.
  [[nodiscard]] double square(double c) const {
    double sum = 0;
    for (std::size_t i = 0; i < variances.size(); ++i) {
      const double value = residual(static_cast<Eigen::Index>(i));
      sum += value * value / (1 + c * variances[i]);
    }
    return variances.empty() ? 0 : sum / static_cast<double>(variances.size());
  }

  /// -2 ln of the likelihood.
  [[nodiscard]] double deviance(double c) const {
    double logs = 0;
    for (const double variance : variances) {
      logs += std::log(1 + c * variance);
    }
    const double here = square(c);
    return here > 0 ? logs + static_cast<double>(variances.size()) * std::log(here) : 0;
  }
};

double deviance(const std::vector<Spread>& spreads, double c) {
  double sum = 0;
  for (const Spread& spread : spreads) {
    sum += spread.deviance(c);
  }
  return sum;
}

double most_likely_c(const std::vector<Spread>& spreads, double samples) {
  double best = 0;
  double least = deviance(spreads, 0) - 2 * kLeastGain * samples;
  for (int i = 0; i < kLadderSteps; ++i) {
    const double c = kLeast_c * std::pow(kStep, i);
    const double here = deviance(spreads, c);
    if (here < least) {
      least = here;
      best = c;
    }
  }
  return best;
}

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

SampleWeights sample_weights(std::span<const Session> sessions,
                             const std::vector<Eigen::VectorXd>& residuals) {
  std::vector<Spread> spreads;
  double samples = 0;
  double all = 0;
  for (std::size_t s = 0; s < sessions.size(); ++s) {
    spreads.push_back({variances_of(sessions[s].covariates), residuals[s]});
    samples += static_cast<double>(sessions[s].covariates.samples());
    all = std::accumulate(spreads.back().variances.begin(), spreads.back().variances.end(), all);
  }
  for (Spread& spread : spreads) {
    for (double& variance : spread.variances) {
      variance *= samples / all;
    }
  }
  double square = 0;
  for (const Spread& spread : spreads) {
    square += spread.residual.squaredNorm() / samples;
  }
  const double c = most_likely_c(spreads, samples);
  if (square == 0 || deviance(spreads, c) > samples * std::log(square) - 2 * kLeastGain * samples) {
    return {};
  }
  SampleWeights weights;
  double sum = 0;
  for (const Spread& spread : spreads) {
    const double here_square = std::max(spread.square(c), kLeastOfMean * square);
    std::vector<double>& here = weights.emplace_back();
    for (const double variance : spread.variances) {
      here.push_back(1 / (here_square * (1 + c * variance)));
      sum += here.back();
    }
  }
  for (std::vector<double>& here : weights) {
    for (double& value : here) {
      value *= samples / sum;
    }
  }
  return weights;
}

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
