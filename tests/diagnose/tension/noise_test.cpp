#include "host_sim/diagnose/tension/noise.hpp"

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

/// Two effects, so that sessions have enough to themselves.
std::vector<Wanted> two_effects() {
  const Component heat = component("friction_temperature");
  const Component offset = component("current_offset", {0.04});
  return wanted_of(std::vector{heat, offset});
}

SampleNoise noise_in(const std::vector<Session>& sessions, unsigned threads = 1) {
  const Evidence evidence = evidence_of(sessions, 1);
  return sample_noise(sessions, evidence.options.baseline, two_effects(), threads);
}

TEST(SampleNoise, OfWhiteNoiseIsItsSize) {
  const SampleNoise noise = noise_in(noisy_sessions(small_design(), {.sample_sd = 0.02}, 1));
  EXPECT_NEAR(noise.autocorrelation, 0, 0.05);
  EXPECT_NEAR(noise.sample_sd, 0.02, 0.002);
}

TEST(SampleNoise, OfFirstOrderNoiseIsThatOfItsInnovations) {
  const SampleNoise noise =
      noise_in(noisy_sessions(small_design(), {.sample_sd = 0.02, .ar1 = 0.8}, 1));
  EXPECT_NEAR(noise.autocorrelation, 0.8, 0.051);   // to the next of those that are tried
  EXPECT_NEAR(noise.sample_sd, 0.02 * 0.6, 0.002);  // sqrt(1 - 0.8^2)
}

TEST(SampleNoise, HoldsNothingOfEffectsAndScatterOfSessions) {
  const Disturbances disturbances{.sample_sd = 0.02,
                                  .session_gain_sd = 0.5,
                                  .session_friction_sd = 0.1,
                                  .effect = [](const recording::Covariates& c, std::size_t i) {
                                    return -kMu * 0.2 * (c.sheath_temperature_C[i] - 20) *
                                           c.bend_angle_rad[i] * c.direction[i];
                                  }};
  EXPECT_NEAR(noise_in(noisy_sessions(small_design(), disturbances, 1)).sample_sd, 0.02, 0.002);
}

/// White noise with a slow one of a tenth of its variance beside: at low frequency the slow one is
/// most of it.
TEST(SampleNoise, CountsSlowNoiseByItsVarianceAtLowFrequency) {
  auto runs = small_design();
  for (auto& run : runs) {
    run.duration_s = 20;
  }
  std::vector<Session> sessions =
      noisy_sessions(runs, {.sample_sd = 0.02, .session_gain_sd = 0, .session_friction_sd = 0}, 1);
  const std::vector<Session> slow = noisy_sessions(runs,
                                                   {.sample_sd = 0.02 / std::sqrt(10.0),
                                                    .ar1 = 0.9,
                                                    .session_gain_sd = 0,
                                                    .session_friction_sd = 0},
                                                   2);
  const std::vector<Session> clean = sessions_of(runs);
  for (std::size_t s = 0; s < sessions.size(); ++s) {
    for (std::size_t i = 0; i < clean[s].covariates.samples(); ++i) {
      sessions[s].covariates.output_tension_N[i] *=
          slow[s].covariates.output_tension_N[i] / clean[s].covariates.output_tension_N[i];
    }
  }
  const SampleNoise noise = noise_in(sessions);
  // The sum has a correlation of 0.9/11 at lag 1, and at frequency 0 a variance of
  // 0.02^2 (1 + 0.1 1.9/0.1).
  EXPECT_NEAR(noise.autocorrelation, 0.9 / 11, 0.03);
  const double at_zero_sd = noise.sample_sd / (1 - noise.autocorrelation);
  EXPECT_NEAR(at_zero_sd, 0.02 * std::sqrt(2.9), 0.004);
}

TEST(SampleNoise, IsNotANumberWithoutNoiseNever) {
  std::vector<Session> sessions = sessions_of(small_design());
  for (Session& session : sessions) {
    session.covariates.output_tension_N = session.covariates.current_tension_N;
    session.covariates.bend_angle_rad.assign(session.covariates.samples(), 0);
  }
  const SampleNoise noise = noise_in(sessions);
  EXPECT_TRUE(std::isfinite(noise.autocorrelation));
  EXPECT_GT(noise.sample_sd, 0);
}

TEST(SampleNoise, IsTheSameForAnyNumberOfThreads) {
  const std::vector<Session> sessions = noisy_sessions(small_design(), {}, 3);
  EXPECT_EQ(noise_in(sessions, 1).sample_sd, noise_in(sessions, 3).sample_sd);
}

}  // namespace
}  // namespace host_sim::diagnose::testing
