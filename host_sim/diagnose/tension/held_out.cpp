#include "host_sim/diagnose/tension/held_out.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "host_sim/diagnose/tension/model_fit.hpp"
#include "host_sim/reference/reference.hpp"
#include "host_sim/statistics/parallel.hpp"

namespace host_sim::diagnose {
namespace {

using Eigen::Index;

constexpr std::size_t kMostFolds = 6;

/// Of that assumed, where a model leaves nothing at all.
constexpr double kLeastVariance = 1e-6;

double square_off(const std::vector<double>& one_N, const std::vector<double>& other_N) {
  double sum = 0;
  for (std::size_t i = 0; i < one_N.size(); ++i) {
    sum += (one_N[i] - other_N[i]) * (one_N[i] - other_N[i]);
  }
  return sum;
}

/// e' V^-1 e and ln|V| of one session's whitened residual under a fit.
struct Density {
  double square = 0;
  double log_determinant = 0;
};

Density density_of(const SessionGram& session, const ModelFit& fit, const Terms& terms) {
  const Index last = session.gram.rows() - 1;
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(last + 1);
  weights(last) = 1;
  weights.head<2>() = -fit.coefficients.head<2>();
  for (std::size_t i = 0; i < terms.columns.size(); ++i) {
    weights(terms.columns[i]) = -fit.coefficients(static_cast<Index>(i) + 2);
  }
  const double variance = fit.noise.sample_sd * fit.noise.sample_sd;
  const Eigen::Vector2d sd(fit.noise.session_gain_sd, fit.noise.session_friction_sd);
  const Eigen::Matrix2d added =
      sd.asDiagonal() * session.gram.topLeftCorner<2, 2>() * sd.asDiagonal() / variance;
  Density density;
  density.square = weights.dot(session_information(session, fit.noise) * weights);
  density.log_determinant = std::log((Eigen::Matrix2d::Identity() + added).determinant()) +
                            static_cast<double>(session.samples) * std::log(variance) -
                            session.log_weights;
  return density;
}

/// The same fit with the noise that its own sessions left, so that a wrong model is not punished
/// for noise that it never claimed to know.
ModelFit with_own_noise(const Grams& grams, const Terms& terms,
                        std::span<const std::size_t> sessions, double sample_sd) {
  ModelFit fit = fit_model(grams, terms, sessions, sample_sd);
  double square = 0;
  double samples = 0;
  for (const std::size_t place : sessions) {
    square += density_of(grams.sessions[place], fit, terms).square;
    samples += static_cast<double>(grams.sessions[place].samples);
  }
  const double found = std::sqrt(std::max(square / samples, kLeastVariance));
  return fit_model(grams, terms, sessions, sample_sd * found);
}

SessionScore score_of(const Session& session, const SessionGram& gram, const Grams& grams,
                      const ModelFit& fit, const Terms& terms,
                      const reference::Constants& constants) {
  const std::vector<double>& measured_N = session.covariates.output_tension_N;
  const Predicted predicted = predict(session, grams.layout, grams.baseline, fit);
  SessionScore score;
  score.samples = static_cast<double>(measured_N.size());
  score.output_square_N2 = square_off(predicted.output_N, measured_N);
  score.input_square_N2 = square_off(predicted.input_N, session.covariates.tension_in_N());
  const Density density = density_of(gram, fit, terms);
  score.log_density =
      -(density.square + density.log_determinant + score.samples * std::log(2 * std::numbers::pi)) /
      2;
  const double damage = damage_of(measured_N, constants);
  if (damage > 0) {
    score.damage_error = std::abs(damage_of(predicted.output_N, constants) / damage - 1);
  }
  return score;
}

}  // namespace

double HeldOut::sum(double SessionScore::*figure) const {
  double sum = 0;
  for (const SessionScore& session : sessions) {
    sum += session.*figure;
  }
  return sum;
}

double HeldOut::output_rmse_N() const {
  return std::sqrt(sum(&SessionScore::output_square_N2) / sum(&SessionScore::samples));
}

double HeldOut::input_rmse_N() const {
  return std::sqrt(sum(&SessionScore::input_square_N2) / sum(&SessionScore::samples));
}

double HeldOut::log_density() const {
  return sum(&SessionScore::log_density) / sum(&SessionScore::samples);
}

HeldOut held_out(const Evidence& evidence, std::span<const Component> model,
                 const reference::Constants& constants) {
  GramOptions options = evidence.options;
  options.wanted = wanted_of(model);
  const Grams grams = gram_of(evidence.sessions, options);
  const Terms terms = terms_of(grams.layout);
  const std::size_t folds = std::min(kMostFolds, grams.sessions.size());
  HeldOut scores{.sessions = std::vector<SessionScore>(grams.sessions.size())};
  statistics::parallel_for(
      folds,
      [&](std::size_t fold) {
        std::vector<std::size_t> kept;
        for (std::size_t i = 0; i < grams.sessions.size(); ++i) {
          if (i % folds != fold) {
            kept.push_back(i);
          }
        }
        const ModelFit fit = with_own_noise(grams, terms, kept, evidence.sample_sd);
        for (std::size_t i = fold; i < grams.sessions.size(); i += folds) {
          scores.sessions[i] =
              score_of(evidence.sessions[i], grams.sessions[i], grams, fit, terms, constants);
        }
      },
      evidence.options.threads);
  return scores;
}

HeldOutGain measure_gain(const Evidence& evidence, std::span<const Component> model,
                         const reference::Constants& constants) {
  const HeldOut before = held_out(evidence, {}, constants);
  const HeldOut after = held_out(evidence, model, constants);
  const auto mean_damage_error = [](const HeldOut& scores) {
    return scores.sum(&SessionScore::damage_error) / static_cast<double>(scores.sessions.size());
  };
  HeldOutGain gain{.held_out_by = "session", .metrics = {}};
  gain.metrics.push_back({"rmse_N", before.output_rmse_N(), after.output_rmse_N()});
  gain.metrics.push_back({"log_predictive_density", before.log_density(), after.log_density()});
  gain.metrics.push_back(
      {"damage_error_percent", 100 * mean_damage_error(before), 100 * mean_damage_error(after)});
  return gain;
}

}  // namespace host_sim::diagnose
