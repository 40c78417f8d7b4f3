#include "tests/blind/oracle/visibility.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/blind/support.hpp"

namespace blind::test {
namespace {

const std::vector<double> kBend{1, 1, -1, -1};
const std::vector<double> kApart{0.2, -0.2, 0.2, -0.2};  // orthogonal to 1 and to the bend

TEST(SessionInformation, OfWhiteNoiseIsTheSumOfSquares) {
  const Information information = session_information(kApart, kBend, {0.1, 0, 0, 0});
  EXPECT_NEAR(information(0, 0), 4 * 0.04 / 0.01, 1e-9);
  EXPECT_NEAR(sigmas_of(information), 4, 1e-9);
}

TEST(SessionInformation, WhatGainAndFrictionTakeUpIsInvisible) {
  const Information information =
      session_information({0.5, 0.5, -0.1, -0.1}, kBend, {0.1, 0, 0, 0});
  EXPECT_NEAR(sigmas_of(information), 0, 1e-5);
}

// V^-1 of two samples is [[1, -rho], [-rho, 1]] / (sd^2 (1 - rho^2)): 1 / 0.75 for (1, 0), and
// 2 (1 - 0.5) / 0.75 for (1, 1).
TEST(SessionInformation, CorrelatedNoise) {
  const Information information = session_information({1, 0}, {1, 1}, {1, 0.5, 0, 0});
  EXPECT_NEAR(information(0, 0), 4.0 / 3, 1e-9);
  EXPECT_NEAR(information(1, 1), 4.0 / 3, 1e-9);
}

// A session's mean of four samples of sd 0.1, and a scatter of 0.05: 1 / (0.0025 + 0.0025).
TEST(SessionInformation, ScatterOfSessionsBoundsTheGain) {
  const Information information = session_information(kApart, kBend, {0.1, 0, 0.05, 0});
  EXPECT_NEAR(information(1, 1), 200, 1e-6);
  EXPECT_NEAR(information(0, 0), 16, 1e-6);
}

TEST(SessionInformation, ScatterOfFrictionBoundsFriction) {
  const Information information = session_information(kApart, kBend, {0.1, 0, 0, 0.05});
  EXPECT_NEAR(information(2, 2), 200, 1e-6);
}

Scenario with_noise(const std::string& text) {
  Scenario scenario = small_scenario();
  const std::string was = "log_tension_sd = 0.01";
  scenario.plan.replace(scenario.plan.find(was), was.size(), text);
  return scenario;
}

// Friction of sessions at 0, 500 and 1000 cycles is 0.1, 0.115 and 0.13, at phi = pi: the trace is
// -pi s (0, 0.015, 0.03), less its mean: sums of squares 2 * (pi 0.015)^2 * 100 samples, noise
// 0.01 sqrt 2.
TEST(Visibility, OfWearByHand) {
  const double trace = std::sqrt(200.0) * 3.14159265 * 0.015 / (0.01 * std::sqrt(2.0));
  const auto found = visibility_of(small_scenario());
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0], trace, 0.01 * trace);
}

TEST(Visibility, HalvesWithTwiceTheNoise) {
  const double once = visibility_of(small_scenario()).at(0);
  const double twice = visibility_of(with_noise("log_tension_sd = 0.02")).at(0);
  EXPECT_NEAR(twice, once / 2, 1e-6 * once);
}

TEST(Visibility, NothingHiddenHasNone) {
  Scenario scenario = small_scenario();
  scenario.hidden.clear();
  EXPECT_TRUE(visibility_of(scenario).empty());
}

/// Two levels with two specimens each from two lots, stored for no time or for 100 days.
Scenario ageing_lives() {
  Scenario scenario;
  scenario.seed = 5;
  scenario.data = Data::lives;
  scenario.kind = CampaignKind::one;
  scenario.hidden.push_back({"ageing", false, {{"rate_1_day", {0.01}}}, {}});
  scenario.plan = R"(
[campaign]
name = "lives"
[model.cable]
diameter_mm = 0.457
ultimate_tension_N = 177.4
[model.sheath]
friction_coefficient = 0.128
bend_angle_deg = 270.0
[model.life]
mean_stress = "gerber"
ipl_scale = 1.53e5
ipl_exponent = 1.38
weibull_shape = 5.0
[lives]
storage_days = [0.0, 100.0]
[[lives.level]]
bend_angle_deg = 90.0
output_tension_mean_N = 20.0
output_tension_amplitude_N = 20.0
frequency_Hz = 10.0
specimens = 2
[[lives.level]]
bend_angle_deg = 270.0
output_tension_mean_N = 20.0
output_tension_amplitude_N = 20.0
frequency_Hz = 10.0
specimens = 2
[effects.ageing]
rate_1_day = 0.01
)";
  return scenario;
}

// Lives of the stored ones are shorter by exp(1): +-0.5 about the mean of each level, four times,
// norm 1; one specimen's sd is 1.2825 / 5.
TEST(LifeVisibility, OfAgeingByHand) {
  EXPECT_NEAR(life_visibility(ageing_lives(), "ageing"), 5 / 1.2825, 0.01);
}

// The law can take up a changed mean stress in all designs that are tried.
TEST(LifeVisibility, HiddenEffectsAreVisible) {
  int effects = 0;
  int hardly = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Scenario scenario = draw_visible_lives(seed);
    for (const HiddenEffect& effect : scenario.hidden) {
      ++effects;
      const bool visible = life_visibility(scenario, effect.id) >= 3;
      hardly += visible ? 0 : 1;
      EXPECT_TRUE(visible || effect.id == "mean_stress") << seed << ' ' << effect.id;
    }
  }
  EXPECT_GE(effects, 30);
  EXPECT_LE(hardly, effects / 10);
}

// Output tension is 30 N +- 10 N, of mean square 950 N^2; the noise of both sensors is 0.001.
TEST(Floor, IsTheNoiseThatNoModelExplains) {
  const double expected_N = std::sqrt(950.0) * 0.001 * std::sqrt(2.0);
  EXPECT_NEAR(rmse_floor_N(with_noise("log_tension_sd = 0.001")), expected_N, 0.1 * expected_N);
}

TEST(Floor, RelativeGainIsTheShareOfTheWayDown) {
  EXPECT_NEAR(relative_gain(4, 1, 1), 1, 1e-12);
  EXPECT_NEAR(relative_gain(4, 2.5, 1), 0.5, 1e-12);
  EXPECT_EQ(relative_gain(4, 4, 1), 0);
}

}  // namespace
}  // namespace blind::test
