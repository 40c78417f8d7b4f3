#include "host_sim/diagnose/tension/model_fit.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "tests/diagnose/tension/noisy_sessions.hpp"
#include "tests/support/algebra.hpp"

namespace host_sim::diagnose::testing {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Gain, friction, a signature and its prior, from the covariance of all samples as one matrix.
struct Dense {
  VectorXd coefficients;
  MatrixXd covariance;
};

Dense by_one_matrix(const std::vector<Session>& sessions, const Grams& grams, const Terms& terms,
                    const NoiseModel& noise) {
  MatrixXd information = MatrixXd::Zero(3, 3);
  VectorXd products = VectorXd::Zero(3);
  for (const Session& session : sessions) {
    const MatrixXd columns = columns_of(session, grams.layout, grams.baseline);
    const MatrixXd scatter =
        columns.leftCols(2) *
        Eigen::Vector2d(noise.session_gain_sd, noise.session_friction_sd).asDiagonal();
    const MatrixXd covariance =
        MatrixXd::Identity(columns.rows(), columns.rows()) * noise.sample_sd * noise.sample_sd +
        scatter * scatter.transpose();
    const MatrixXd weighted = algebra::solved(covariance, columns.leftCols(3));
    information += weighted.transpose() * columns.leftCols(3);
    products += weighted.transpose() * columns.rightCols<1>();
  }
  const double variance = terms.prior_sd[0] * terms.prior_sd[0];
  information(2, 2) += 1 / variance;
  products(2) += terms.prior_mean[0] / variance;
  const MatrixXd inverse = algebra::inverse(information);
  return {inverse * products, inverse};
}

/// Offset of 0.04 A beside noise; the signature is that of 0.05 A, whose share is expected near 1.
std::vector<Session> with_offset(std::uint64_t seed) {
  return noisy_sessions(
      small_design(),
      {.sample_sd = kSample_sd,
       .session_gain_sd = 0.03,
       .session_friction_sd = 0.01,
       .effect = [](const recording::Covariates& c,
                    std::size_t i) { return std::log(1 - 0.04 / c.current_A[i]); }},
      seed);
}

Grams offset_grams(const std::vector<Session>& sessions) {
  GramOptions options = evidence_of(sessions, kSample_sd).options;
  options.wanted = wanted_of(std::vector{component("current_offset", {0.05})});
  return gram_of(sessions, options);
}

void expect_like(const ModelFit& fit, const Dense& dense) {
  ASSERT_EQ(fit.coefficients.size(), 3);
  for (Index i = 0; i < 3; ++i) {
    // Gain and friction have priors that are wide, not none.
    EXPECT_NEAR(fit.coefficients(i), dense.coefficients(i), 1e-4 * std::abs(dense.coefficients(i)));
    for (Index j = 0; j < 3; ++j) {
      EXPECT_NEAR(fit.covariance(i, j), dense.covariance(i, j),
                  1e-4 * std::sqrt(dense.covariance(i, i) * dense.covariance(j, j)));
    }
  }
}

TEST(ModelFit, IsGeneralisedLeastSquaresOfTheWholeCovariance) {
  const std::vector<Session> sessions = with_offset(4);
  const Grams grams = offset_grams(sessions);
  const Terms terms = terms_of(grams.layout);
  const ModelFit fit = fit_model(grams, terms, kSample_sd);
  expect_like(fit, by_one_matrix(sessions, grams, terms, fit.noise));
  EXPECT_NEAR(fit.coefficients(2), 0.8, 0.1);  // 0.04 of 0.05 A
}

TEST(ModelFit, OfSomeSessionsSeesNoOthers) {
  const std::vector<Session> sessions = with_offset(4);
  const Grams grams = offset_grams(sessions);
  const Terms terms = terms_of(grams.layout);
  const std::vector<std::size_t> kept{0, 3, 4, 8, 9, 11};
  std::vector<Session> some;
  for (const std::size_t place : kept) {
    some.push_back(sessions[place]);
  }
  const ModelFit fit = fit_model(grams, terms, kept, kSample_sd);
  expect_like(fit, by_one_matrix(some, grams, terms, fit.noise));
}

TEST(ModelFit, FindsTheScatterOfSessions) {
  double log_gain = 0;
  double log_friction = 0;
  constexpr int kCampaigns = 12;
  for (int i = 0; i < kCampaigns; ++i) {
    const std::vector<Session> sessions = with_offset(static_cast<std::uint64_t>(i));
    const Grams grams = offset_grams(sessions);
    const ModelFit fit = fit_model(grams, terms_of(grams.layout), kSample_sd);
    EXPECT_EQ(fit.noise.sample_sd, kSample_sd);
    log_gain += std::log(fit.noise.session_gain_sd) / kCampaigns;
    log_friction += std::log(fit.noise.session_friction_sd) / kCampaigns;
  }
  // Neighbours on the grid differ by a factor of two.
  EXPECT_NEAR(std::exp(log_gain), 0.03, 0.01);
  EXPECT_NEAR(std::exp(log_friction), 0.01, 0.0035);
}

/// Sessions that scatter as the model has it show about its covariance; an effect of another size
/// in each pose, which the model does not have, shows more.
TEST(ModelFit, SessionsThatDisagreeSayLess) {
  const std::vector<Session> alike = with_offset(4);
  const Grams grams = offset_grams(alike);
  const ModelFit fit = fit_model(grams, terms_of(grams.layout), kSample_sd);
  EXPECT_EQ(fit.degrees_of_freedom, 12 - 3);
  EXPECT_GT(fit.covariance_by_sessions(2, 2), 0.2 * fit.covariance(2, 2));
  EXPECT_LT(fit.covariance_by_sessions(2, 2), 5 * fit.covariance(2, 2));
  const std::vector<Session> unlike = noisy_sessions(
      small_design(),
      {.sample_sd = kSample_sd,
       .effect =
           [](const recording::Covariates& c, std::size_t i) {
             return std::log(1 - (c.bend_angle_rad[i] < 2 ? 0.02 : 0.06) / c.current_A[i]);
           }},
      4);
  const Grams of_unlike = offset_grams(unlike);
  const ModelFit between = fit_model(of_unlike, terms_of(of_unlike.layout), kSample_sd);
  EXPECT_GT(between.covariance_by_sessions(2, 2), 5 * between.covariance(2, 2));
}

TEST(WithoutOutliers, SamplesThatAreFarOffHaveNoPart) {
  std::vector<Session> sessions = with_offset(4);
  for (std::size_t i = 10; i < sessions[3].covariates.samples(); i += 40) {
    sessions[3].covariates.output_tension_N[i] *= std::exp(0.5);  // 25 standard deviations
  }
  const SampleWeights weights = weights_without_outliers(
      evidence_of(sessions, kSample_sd), std::vector{component("current_offset", {0.04})});
  ASSERT_EQ(weights.size(), sessions.size());
  for (std::size_t i = 10; i < weights[3].size(); i += 40) {
    EXPECT_LT(weights[3][i], 1e-5);
  }
  // A normal sample in 16,000 is as far off.
  for (const std::size_t other : {0U, 7U}) {
    EXPECT_LE(std::ranges::count_if(weights[other], [](double weight) { return weight < 1; }), 2);
  }
}

/// T_out = (T_in - F s) exp(-mu phi s), and the other way round, whatever the tension that is asked
/// for was measured as.
TEST(Predicted, IsOfTheOtherTensionAlone) {
  std::vector<Session> sessions = sessions_of(small_design());
  const Session& measured = sessions[3];
  const Evidence evidence = evidence_of(sessions, 0.01);
  const std::vector<Component> preload{component("friction_preload", {4})};
  const GramLayout layout = layout_of(sessions, evidence.options.baseline, wanted_of(preload));
  const ModelFit fit{.noise = {}, .coefficients = Eigen::Vector3d(0, 0, 1), .covariance = {}};
  const Predicted predicted = predict(measured, layout, evidence.options.baseline, fit);
  const recording::Covariates& c = measured.covariates;
  for (std::size_t i = 0; i < c.samples(); ++i) {
    const double gripped = std::exp(kMu * c.bend_angle_rad[i] * c.direction[i]);
    const double preload_N = 4 * c.direction[i];
    ASSERT_NEAR(predicted.output_N[i], (c.tension_in_N()[i] - preload_N) / gripped, 1e-2);
    ASSERT_NEAR(predicted.input_N[i], c.output_tension_N[i] * gripped + preload_N, 1e-2);
  }
}

}  // namespace
}  // namespace host_sim::diagnose::testing
