#include "host_sim/diagnose/tension/held_out.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "tests/diagnose/tension/noisy_sessions.hpp"

namespace host_sim::diagnose::testing {
namespace {

constexpr double kPreload_N = 3;

const Metric& metric(const HeldOutGain& gain, std::string_view name) {
  for (const Metric& metric : gain.metrics) {
    if (metric.name == name) {
      return metric;
    }
  }
  throw std::out_of_range("no such metric");
}

TEST(Gain, OfAPerfectModelLeavesNoErrorOnSessionsHeldOut) {
  const std::vector<Session> sessions = noisy_sessions(small_design(),
                                                       {.sample_sd = 0,
                                                        .session_gain_sd = 0,
                                                        .session_friction_sd = 0,
                                                        .effect = preload(kPreload_N)},
                                                       1);
  const HeldOutGain gain = measure_gain(
      evidence_of(sessions, 1e-3), std::vector{component("friction_preload", {kPreload_N})}, kWire);
  EXPECT_EQ(gain.held_out_by, "session");
  EXPECT_GT(metric(gain, "rmse_N").before, 0.5);
  EXPECT_NEAR(metric(gain, "rmse_N").after, 0, 1e-6);
  EXPECT_GT(metric(gain, "log_predictive_density").after,
            metric(gain, "log_predictive_density").before + 1);
  EXPECT_TRUE(std::isfinite(metric(gain, "log_predictive_density").after));
  EXPECT_GT(metric(gain, "damage_error_percent").before, 0.1);
  EXPECT_NEAR(metric(gain, "damage_error_percent").after, 0, 1e-4);
}

/// T_out is off by a factor exp(+-0.02) from sample to sample, which no gain or friction mends.
TEST(Gain, RmseIsInNewtonsOverAllSamples) {
  std::vector<Session> sessions = sessions_of(small_design());
  double square_N2 = 0;
  double samples = 0;
  for (Session& session : sessions) {
    std::vector<double>& output_N = session.covariates.output_tension_N;
    for (std::size_t i = 0; i < output_N.size(); ++i) {
      const double predicted_N = output_N[i];
      output_N[i] *= std::exp(i % 2 == 0 ? 0.02 : -0.02);
      square_N2 += (predicted_N - output_N[i]) * (predicted_N - output_N[i]);
      samples += 1;
    }
  }
  const HeldOutGain gain = measure_gain(evidence_of(sessions, 0.02), {}, kWire);
  EXPECT_NEAR(metric(gain, "rmse_N").before, std::sqrt(square_N2 / samples), 2e-3);
  EXPECT_EQ(metric(gain, "rmse_N").before, metric(gain, "rmse_N").after);
}

/// Of three sessions alike but for a gain of 0, 0 and 0.3 each is predicted by the mean of the
/// other two, 0.15, 0.15 and 0.
TEST(Gain, IsOfSessionsThatTheFitNeverSaw) {
  std::vector<Session> sessions = sessions_of({{}, {}, {}});
  double square_N2 = 0;
  double samples = 0;
  for (std::size_t s = 0; s < sessions.size(); ++s) {
    for (double& output_N : sessions[s].covariates.output_tension_N) {
      const double predicted_N = output_N * std::exp(s == 2 ? 0 : 0.15);
      output_N *= std::exp(s == 2 ? 0.3 : 0);
      square_N2 += (predicted_N - output_N) * (predicted_N - output_N);
      samples += 1;
    }
  }
  const HeldOutGain gain = measure_gain(evidence_of(sessions, 0.01), {}, kWire);
  const double expected_N = std::sqrt(square_N2 / samples);
  EXPECT_NEAR(metric(gain, "rmse_N").before, expected_N, 0.01 * expected_N);
}

/// White noise of size sd has -1/2 ln(2 pi e sd^2) in the mean, whatever size was assumed before.
TEST(Gain, LogDensityIsThatOfTheNoise) {
  const std::vector<Session> sessions = noisy_sessions(
      small_design(), {.sample_sd = kSample_sd, .session_gain_sd = 0, .session_friction_sd = 0}, 1);
  const double expected =
      -std::log(2 * std::numbers::pi * std::numbers::e * kSample_sd * kSample_sd) / 2;
  for (const double assumed_sd : {0.01, 0.02, 0.03}) {
    const HeldOutGain gain = measure_gain(evidence_of(sessions, assumed_sd), {}, kWire);
    // 2400 samples: the mean of e^2/2sd^2 has a standard error of 1/sqrt(4800).
    EXPECT_NEAR(metric(gain, "log_predictive_density").before, expected, 4 / std::sqrt(4800.0));
  }
}

TEST(Gain, OfAnEffectThatIsNotThereIsNone) {
  const std::vector<Session> sessions = noisy_sessions(small_design(), {}, 1);
  const HeldOutGain gain = measure_gain(evidence_of(sessions, 0.01),
                                        std::vector{component("friction_temperature")}, kWire);
  EXPECT_LT(metric(gain, "log_predictive_density").after,
            metric(gain, "log_predictive_density").before + 0.005);
}

TEST(Damage, GrowsWithTheNumberOfCyclesAndIsNoneWithoutAny) {
  std::vector<double> cycles_N;
  const auto turn_N = [](int k) { return 50 + 20 * std::sin(2 * std::numbers::pi * k / 40.0); };
  for (int k = 0; k <= 40 * 10; ++k) {
    cycles_N.push_back(turn_N(k));
  }
  const double ten = damage_of(cycles_N, kWire);
  for (int k = 1; k <= 40 * 10; ++k) {
    cycles_N.push_back(turn_N(k));
  }
  EXPECT_GT(ten, 0);
  EXPECT_NEAR(damage_of(cycles_N, kWire) / ten, 2, 0.1);
  EXPECT_EQ(damage_of(std::vector<double>(100, 50.0), kWire), 0);
}

}  // namespace
}  // namespace host_sim::diagnose::testing
