#include "host_sim/recording/channel_noise.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace host_sim::recording {
namespace {

/// 20 s at 200 Hz: 5 .. 45 N as 0.7 Hz has it, the tendon 0.3 Hz.
Covariates moving() {
  Covariates covariates;
  for (int i = 0; i < 4000; ++i) {
    const double t = 0.005 * i;
    covariates.time_s.push_back(t);
    covariates.direction.push_back(std::cos(2 * std::numbers::pi * 0.3 * t) > 0 ? 1 : -1);
    covariates.output_tension_N.push_back(25 + 20 * std::sin(2 * std::numbers::pi * 0.7 * t));
    covariates.input_tension_N.push_back(covariates.output_tension_N.back() *
                                         std::exp(0.4 * covariates.direction.back()));
  }
  return covariates;
}

std::vector<double> noisy(std::vector<double> tension_N, double absolute_N, double relative) {
  std::mt19937 engine(3);
  std::normal_distribution<double> normal;
  for (double& value_N : tension_N) {
    value_N += normal(engine) * std::hypot(absolute_N, relative * value_N);
  }
  return tension_N;
}

TEST(ChannelNoise, IsWhatWasAdded) {
  const Covariates covariates = moving();
  const ChannelNoise floor = channel_noise(covariates, noisy(covariates.output_tension_N, 0.2, 0));
  EXPECT_NEAR(floor.absolute_N, 0.2, 0.02);
  EXPECT_LT(floor.relative, 0.003);
  const ChannelNoise share = channel_noise(covariates, noisy(covariates.output_tension_N, 0, 0.02));
  EXPECT_NEAR(share.relative, 0.02, 0.002);
  EXPECT_LT(share.absolute_N, 0.05);
}

/// A sine of 0.7 Hz has third differences of 20 N (2 pi 0.7 / 200)^3; friction turns over between
/// runs of four samples, and the median does not see it.
TEST(ChannelNoise, IsNotTheMotion) {
  const Covariates covariates = moving();
  EXPECT_LT(channel_noise(covariates, covariates.output_tension_N).absolute_N, 1e-3);
  EXPECT_LT(channel_noise(covariates, covariates.input_tension_N).absolute_N, 1e-3);
}

TEST(ChannelNoise, OfAFewSamplesIsNotKnown) {
  Covariates covariates = moving();
  covariates.time_s.resize(60);
  covariates.direction.resize(60);
  const std::vector<double> few(60, 10.0);
  EXPECT_EQ(channel_noise(covariates, noisy(few, 1, 0)).absolute_N, 0);
}

TEST(AddNoise, GivesEachEndItsVarianceOfTheLogarithm) {
  Covariates covariates = moving();
  covariates.input_tension_N = noisy(covariates.input_tension_N, 0, 0.02);
  add_noise(covariates);
  ASSERT_EQ(covariates.input_noise.size(), covariates.samples());
  ASSERT_EQ(covariates.output_noise.size(), covariates.samples());
  for (std::size_t i = 0; i < covariates.samples(); ++i) {
    ASSERT_NEAR(std::sqrt(covariates.input_noise[i]), 0.02, 0.004) << i;
    ASSERT_LT(covariates.output_noise[i], 1e-6) << i;
  }
}

TEST(AddNoise, LeavesBothEmptyWithoutNoise) {
  Covariates covariates = moving();
  covariates.input_tension_N.assign(covariates.samples(), 10);
  covariates.output_tension_N.assign(covariates.samples(), 10);
  add_noise(covariates);
  EXPECT_TRUE(covariates.input_noise.empty());
  EXPECT_TRUE(covariates.output_noise.empty());
}

}  // namespace
}  // namespace host_sim::recording
