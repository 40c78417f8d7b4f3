#include "host_sim/diagnose/tension/noise.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "host_sim/statistics/parallel.hpp"
#include "host_sim/statistics/random.hpp"

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
constexpr double kLeast_sd = 1e-6;
constexpr Index kLags = 40;

/// First-order autocorrelations of noise that goes through the same fits as what was measured, and
/// shows what of noise they take away. That is more of slow noise than of white.
constexpr std::array kTrials{0.0,  0.3,  0.5,  0.6,   0.68, 0.75, 0.8,
                             0.85, 0.88, 0.91, 0.935, 0.95, 0.97, 0.98};
constexpr std::uint64_t kTrialStream = 0x747269616c;

/// A column for each of kTrials, with innovations of unit variance.
Eigen::MatrixXd trials_of(Index samples, std::size_t session) {
  Eigen::MatrixXd trials(samples, std::ssize(kTrials));
  statistics::Random random(0, kTrialStream, session);
  Eigen::VectorXd innovations(samples);
  for (Index i = 0; i < samples; ++i) {
    innovations(i) = boost::math::quantile(boost::math::normal(), random.uniform());
  }
  for (Index k = 0; k < trials.cols(); ++k) {
    const double correlation = kTrials[static_cast<std::size_t>(k)];
    double value = boost::math::quantile(boost::math::normal(), random.uniform()) /
                   std::sqrt(1 - correlation * correlation);
    for (Index i = 0; i < samples; ++i) {
      value = correlation * value + innovations(i);
      trials(i, k) = value;
    }
  }
  return trials;
}

/// What terms leave of responses, a column each.
Eigen::MatrixXd residuals_of(const Eigen::Ref<const Eigen::MatrixXd>& terms,
                             const Eigen::MatrixXd& responses) {
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(terms.cols(), terms.cols());
  gram.selfadjointView<Eigen::Lower>().rankUpdate(terms.transpose());
  const Eigen::VectorXd unit = gram.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  gram = unit.asDiagonal() * gram * unit.asDiagonal();
  gram.diagonal().array() += kRidge;
  const Eigen::MatrixXd products = unit.asDiagonal() * (terms.transpose() * responses);
  const Eigen::MatrixXd solved = gram.selfadjointView<Eigen::Lower>().ldlt().solve(products);
  return responses - terms * (unit.asDiagonal() * solved);
}

double lag_product(const Eigen::VectorXd& values, Index lag) {
  const Index rest = values.size() - lag;
  return rest <= 0 ? 0 : values.tail(rest).dot(values.head(rest));
}

/// By session, each with everything to itself; weighed where there are weights. The first column is
/// what was measured, the others are kTrials.
std::vector<Eigen::MatrixXd> residuals_of(std::span<const Session> sessions,
                                          const GramLayout& layout,
                                          const effects::Baseline& baseline,
                                          const SampleWeights& weights, unsigned threads,
                                          KeptSignatures* kept) {
  std::vector<Eigen::MatrixXd> residuals(sessions.size());
  statistics::parallel_for(
      sessions.size(),
      [&](std::size_t i) {
        Eigen::MatrixXd columns =
            columns_of(sessions[i], layout, baseline, kept == nullptr ? nullptr : &kept->of(i));
        if (!weights.empty()) {
          weigh(columns, weights[i]);
        }
        const Index last = columns.cols() - 1;
        Eigen::MatrixXd responses(columns.rows(), 1 + std::ssize(kTrials));
        responses << columns.col(last), trials_of(columns.rows(), i);
        residuals[i] = residuals_of(columns.leftCols(last), responses);
      },
      threads);
  return residuals;
}

/// Of one column of residuals, by lag up to kLags.
Eigen::VectorXd autocovariance(const std::vector<Eigen::MatrixXd>& residuals, Index column) {
  Eigen::VectorXd products = Eigen::VectorXd::Zero(kLags + 1);
  double samples = 0;
  for (const Eigen::MatrixXd& residual : residuals) {
    samples += static_cast<double>(residual.rows());
    for (Index lag = 0; lag <= kLags; ++lag) {
      products(lag) += lag_product(residual.col(column), lag);
    }
  }
  return products / samples;
}

/// White noise and noise of first order together.
struct NoiseMixture {
  double white = 0;       ///< variance
  double innovation = 0;  ///< variance of the other's innovations
  double correlation = 0;

  [[nodiscard]] double autocorrelation() const {
    const double slow = innovation / (1 - correlation * correlation);
    return correlation * slow / std::max(white + slow, kLeast_sd * kLeast_sd);
  }
  /// Of sums, for each sample.
  [[nodiscard]] double long_run_variance() const {
    return white + innovation / ((1 - correlation) * (1 - correlation));
  }
};

/// The one whose autocovariance after the fits is nearest to that of what was measured: white
/// noise alone, unless chance hardly ever gives it as much of the other.
NoiseMixture mixture_of(const std::vector<Eigen::MatrixXd>& residuals) {
  constexpr double kBeyondChance = 9;  // three standard deviations of an autocovariance
  const Eigen::VectorXd shown = autocovariance(residuals, 0);
  const Eigen::VectorXd white = autocovariance(residuals, 1);
  double samples = 0;
  for (const Eigen::MatrixXd& residual : residuals) {
    samples += static_cast<double>(residual.rows());
  }
  NoiseMixture best{.white = shown.dot(white) / std::max(white.squaredNorm(), 1e-300)};
  double least = (shown - best.white * white).squaredNorm() -
                 kBeyondChance * shown(0) * shown(0) / std::max(samples, 1.0);
  for (std::size_t k = 1; k < kTrials.size(); ++k) {
    const Eigen::VectorXd slow = autocovariance(residuals, static_cast<Index>(k) + 1);
    const double across = white.dot(slow);
    Eigen::Matrix2d square;
    square << white.squaredNorm(), across, across, slow.squaredNorm();
    const Eigen::Vector2d both =
        square.inverse() * Eigen::Vector2d(white.dot(shown), slow.dot(shown));
    const Eigen::Vector2d alone(0, slow.dot(shown) / std::max(slow.squaredNorm(), 1e-300));
    for (const Eigen::Vector2d& sizes : {both, alone}) {
      const double left = (shown - sizes(0) * white - sizes(1) * slow).squaredNorm();
      if (sizes.minCoeff() >= 0 && left < least) {
        least = left;
        best = {sizes(0), sizes(1), kTrials[k]};
      }
    }
  }
  return best;
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
                         const std::vector<Wanted>& wanted, unsigned threads,
                         KeptSignatures* kept) {
  const GramLayout layout = layout_of(sessions, baseline, wanted);
  SampleNoise noise;
  std::vector<Eigen::MatrixXd> residuals =
      residuals_of(sessions, layout, baseline, {}, threads, kept);
  std::vector<Eigen::VectorXd> measured;
  measured.reserve(residuals.size());
  for (const Eigen::MatrixXd& residual : residuals) {
    measured.emplace_back(residual.col(0));
  }
  noise.weights = sample_weights(sessions, measured);
  if (!noise.weights.empty()) {
    residuals = residuals_of(sessions, layout, baseline, noise.weights, threads, kept);
  }
  const NoiseMixture mixture = mixture_of(residuals);
  noise.autocorrelation = mixture.autocorrelation();
  noise.sample_sd =
      std::max(std::sqrt(mixture.long_run_variance()) * (1 - noise.autocorrelation), kLeast_sd);
  return noise;
}

}  // namespace host_sim::diagnose
