#include "host_sim/diagnose/tension/sample_weights.hpp"

#include <algorithm>
#include <cmath>

namespace host_sim::diagnose {
namespace {

constexpr double kLeast_c = 1e-3;
constexpr double kStep = 1.9952623149688795;  ///< from one c to the next: 10^0.3
constexpr int kLadderSteps = 30;

/// ln of the likelihood ratio for each sample that is not worth the trouble of weights.
constexpr double kLeastGain = 0.005;

double inverse_square(const recording::Covariates& covariates, std::size_t i) {
  const double input_N = covariates.tension_in_N()[i];
  const double output_N = covariates.output_tension_N[i];
  return 1 / (input_N * input_N) + 1 / (output_N * output_N);
}

/// -2 ln of the likelihood over the samples, a^2 at its best.
double deviance(std::span<const Session> sessions, const std::vector<Eigen::VectorXd>& residuals,
                double c_N2) {
  double square = 0;
  double logs = 0;
  double samples = 0;
  for (std::size_t s = 0; s < sessions.size(); ++s) {
    const recording::Covariates& covariates = sessions[s].covariates;
    for (std::size_t i = 0; i < covariates.samples(); ++i) {
      const double variance = 1 + c_N2 * inverse_square(covariates, i);
      const double residual = residuals[s](static_cast<Eigen::Index>(i));
      square += residual * residual / variance;
      logs += std::log(variance);
    }
    samples += static_cast<double>(covariates.samples());
  }
  return square > 0 ? logs / samples + std::log(square / samples) : 0;
}

double most_likely_c(std::span<const Session> sessions,
                     const std::vector<Eigen::VectorXd>& residuals) {
  const double even = deviance(sessions, residuals, 0);
  double best_N2 = 0;
  double least = even - 2 * kLeastGain;
  for (int i = 0; i < kLadderSteps; ++i) {
    const double c_N2 = kLeast_c * std::pow(kStep, i);
    const double here = deviance(sessions, residuals, c_N2);
    if (here < least) {
      least = here;
      best_N2 = c_N2;
    }
  }
  return best_N2;
}

}  // namespace

SampleWeights weights_of_mean_one(
    std::span<const Session> sessions,
    const std::function<double(const recording::Covariates& covariates, std::size_t i)>& weight) {
  SampleWeights weights;
  double sum = 0;
  double samples = 0;
  for (const Session& session : sessions) {
    std::vector<double>& here = weights.emplace_back();
    for (std::size_t i = 0; i < session.covariates.samples(); ++i) {
      here.push_back(weight(session.covariates, i));
      sum += here.back();
    }
    samples += static_cast<double>(here.size());
  }
  for (std::vector<double>& here : weights) {
    for (double& value : here) {
      value *= samples / sum;
    }
  }
  return weights;
}

SampleWeights sample_weights(std::span<const Session> sessions,
                             const std::vector<Eigen::VectorXd>& residuals) {
  const double c_N2 = most_likely_c(sessions, residuals);
  if (c_N2 == 0) {
    return {};
  }
  return weights_of_mean_one(sessions, [&](const recording::Covariates& covariates, std::size_t i) {
    return 1 / (1 + c_N2 * inverse_square(covariates, i));
  });
}

}  // namespace host_sim::diagnose
