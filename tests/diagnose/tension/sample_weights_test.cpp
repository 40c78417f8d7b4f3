#include "host_sim/diagnose/tension/sample_weights.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/diagnose/tension/noisy_sessions.hpp"

namespace host_sim::diagnose::testing {
namespace {

double inverse_square_1_N2(const recording::Covariates& c, std::size_t i) {
  return std::pow(c.tension_in_N()[i], -2) + std::pow(c.output_tension_N[i], -2);
}

/// Of variance 0.01^2 (1 + c q).
std::vector<Eigen::VectorXd> residuals_of(const std::vector<Session>& sessions, double c_N2) {
  std::vector<Eigen::VectorXd> residuals;
  for (std::size_t s = 0; s < sessions.size(); ++s) {
    const recording::Covariates& c = sessions[s].covariates;
    statistics::Random random(7, 0, s);
    Eigen::VectorXd& here = residuals.emplace_back(static_cast<Eigen::Index>(c.samples()));
    for (std::size_t i = 0; i < c.samples(); ++i) {
      here(static_cast<Eigen::Index>(i)) =
          0.01 * std::sqrt(1 + c_N2 * inverse_square_1_N2(c, i)) * normal(random);
    }
  }
  return residuals;
}

TEST(SampleWeights, AreNoneWhereLowTensionIsNotNoisier) {
  const std::vector<Session> sessions = sessions_of(small_design());
  EXPECT_TRUE(sample_weights(sessions, residuals_of(sessions, 0)).empty());
}

/// 400 N^2: a sensor's 0.2 N beside 1 %.
TEST(SampleWeights, AreOneOverTheVariance) {
  const std::vector<Session> sessions = sessions_of(small_design());
  const SampleWeights weights = sample_weights(sessions, residuals_of(sessions, 400));
  ASSERT_EQ(weights.size(), sessions.size());
  double sum = 0;
  double samples = 0;
  for (std::size_t s = 0; s < sessions.size(); ++s) {
    const recording::Covariates& c = sessions[s].covariates;
    ASSERT_EQ(weights[s].size(), c.samples());
    for (std::size_t i = 0; i < c.samples(); ++i) {
      const double expected = (1 + 400 * inverse_square_1_N2(sessions[0].covariates, 0)) /
                              (1 + 400 * inverse_square_1_N2(c, i));
      ASSERT_NEAR(std::log(weights[s][i] / weights[0][0] / expected), 0, 0.4);
      sum += weights[s][i];
      samples += 1;
    }
  }
  EXPECT_NEAR(sum / samples, 1, 1e-9);
}

TEST(SampleWeights, OfNoNoiseAreNone) {
  const std::vector<Session> sessions = sessions_of(small_design());
  std::vector<Eigen::VectorXd> residuals = residuals_of(sessions, 0);
  for (Eigen::VectorXd& residual : residuals) {
    residual.setZero();
  }
  EXPECT_TRUE(sample_weights(sessions, residuals).empty());
}

}  // namespace
}  // namespace host_sim::diagnose::testing
