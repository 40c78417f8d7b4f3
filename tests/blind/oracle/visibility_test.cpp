#include "tests/blind/oracle/visibility.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/blind/support.hpp"

namespace blind::test {
namespace {

/// One source of noise, the same for each of four samples.
Disturbance one_source(double sd, double gain_sd = 0, double friction_sd = 0) {
  return {{{std::vector<double>(4, sd), 0}}, gain_sd, friction_sd};
}

/// A gain moves all samples alike, and friction against the bend.
Information information_of(const std::vector<double>& trace,
                           const std::vector<double>& signed_bend_rad,
                           const Disturbance& disturbance) {
  Eigen::MatrixX3d columns(static_cast<Eigen::Index>(trace.size()), 3);
  for (std::size_t i = 0; i < trace.size(); ++i) {
    columns.row(static_cast<Eigen::Index>(i)) << trace[i], 1, -signed_bend_rad[i];
  }
  return session_information(columns, disturbance);
}

const std::vector<double> kBend{1, 1, -1, -1};
const std::vector<double> kApart{0.2, -0.2, 0.2, -0.2};  // orthogonal to 1 and to the bend

TEST(SessionInformation, OfWhiteNoiseIsTheSumOfSquares) {
  const Information information = information_of(kApart, kBend, one_source(0.1));
  EXPECT_NEAR(information(0, 0), 4 * 0.04 / 0.01, 1e-9);
  EXPECT_NEAR(sigmas_of(information), 4, 1e-9);
}

TEST(SessionInformation, WhatGainAndFrictionTakeUpIsInvisible) {
  const Information information = information_of({0.5, 0.5, -0.1, -0.1}, kBend, one_source(0.1));
  EXPECT_NEAR(sigmas_of(information), 0, 1e-5);
}

// V^-1 of two samples is [[1, -rho], [-rho, 1]] / (sd^2 (1 - rho^2)): 1 / 0.75 for (1, 0), and
// 2 (1 - 0.5) / 0.75 for (1, 1).
TEST(SessionInformation, CorrelatedNoise) {
  const Information information = information_of({1, 0}, {1, 1}, {{{{1, 1}, 0.5}}, 0, 0});
  EXPECT_NEAR(information(0, 0), 4.0 / 3, 1e-9);
  EXPECT_NEAR(information(1, 1), 4.0 / 3, 1e-9);
}

// 0.3 and 0.4 are 0.5 together.
TEST(SessionInformation, SourcesAddUp) {
  const Disturbance both{
      {{std::vector<double>(4, 0.3), 0}, {std::vector<double>(4, 0.4), 0}}, 0, 0};
  EXPECT_NEAR(information_of(kApart, kBend, both)(0, 0), 4 * 0.04 / 0.25, 1e-9);
}

// V of correlations 0.6 and -0.2 is [[2, 0.4], [0.4, 2]], whose inverse is [[2, -0.4], ..] / 3.84.
TEST(SessionInformation, SourcesOfUnlikeCorrelation) {
  const Disturbance both{{{{1, 1}, 0.6}, {{1, 1}, -0.2}}, 0, 0};
  const Information information = information_of({1, 0}, {1, 1}, both);
  EXPECT_NEAR(information(0, 0), 2 / 3.84, 1e-9);
  EXPECT_NEAR(information(0, 1), 1.6 / 3.84, 1e-9);
  EXPECT_NEAR(information(1, 1), 3.2 / 3.84, 1e-9);
}

// V of sds 1 and 2 and a correlation of 0.5 is [[1, 1], [1, 4]], whose inverse is
// [[4, -1], [-1, 1]] / 3.
TEST(SessionInformation, SamplesOfUnlikeNoise) {
  const Information information = information_of({1, 0}, {1, 1}, {{{{1, 2}, 0.5}}, 0, 0});
  EXPECT_NEAR(information(0, 0), 4.0 / 3, 1e-9);
  EXPECT_NEAR(information(0, 1), 1, 1e-9);
  EXPECT_NEAR(information(1, 1), 1, 1e-9);
}

// 20, 25 and 20 N a second apart: slopes of 5 / 20 at the first and the last, 0 in the middle.
TEST(NoiseSources, AreThoseOfBothEnds) {
  host_sim::synth::Channels channels;
  channels[hal::files::kTime] = {0, 1, 2};
  channels[hal::files::kOutputTensionColumn] = {20, 25, 20};
  channels[hal::files::kInputTensionColumn] = {10, 10, 10};
  host_sim::synth::Noise noise;
  noise.output = {.relative_sd = 0.01, .absolute_N = 0.1, .ar1 = 0.5};
  noise.input = {.relative_sd = 0, .absolute_N = 0.2, .absolute_A = 9, .ar1 = 0.25};
  EXPECT_EQ(noise_sources(noise, channels, Input::load_cell).size(), 3U);
  noise.jitter_s = 0.1;
  const auto sources = noise_sources(noise, channels, Input::load_cell);
  ASSERT_EQ(sources.size(), 5U);
  const auto expect = [](const NoiseSource& source, std::vector<double> sd, double ar1) {
    EXPECT_EQ(source.ar1, ar1);
    ASSERT_EQ(source.sd.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(source.sd[i], sd[i], 1e-6);
    }
  };
  expect(sources[0], {0.01, 0.01, 0.01}, 0.5);
  expect(sources[1], {0.005, 0.004, 0.005}, 0.5);
  expect(sources[2], {0.025, 0, 0.025}, 0);
  expect(sources[3], {0.02, 0.02, 0.02}, 0.25);
  expect(sources[4], {0, 0, 0}, 0);
}

// A session's mean of four samples of sd 0.1, and a scatter of 0.05: 1 / (0.0025 + 0.0025).
TEST(SessionInformation, ScatterOfSessionsBoundsTheGain) {
  const Information information = information_of(kApart, kBend, one_source(0.1, 0.05));
  EXPECT_NEAR(information(1, 1), 200, 1e-6);
  EXPECT_NEAR(information(0, 0), 16, 1e-6);
}

TEST(SessionInformation, ScatterOfFrictionBoundsFriction) {
  const Information information = information_of(kApart, kBend, one_source(0.1, 0, 0.05));
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

// Friction of each session scatters by 0.015, beside which noise says nothing: -0.015, 0 and 0.015
// are sqrt(2) of that, and as many where friction comes 2 mm after each reversal.
TEST(Visibility, OfWearIsThatOfFrictionBesideWhateverItDoes) {
  Scenario scenario = small_scenario();
  scenario.plan += "[scatter]\nfriction_sd = 0.015\n";
  EXPECT_NEAR(visibility_of(scenario).at(0), std::sqrt(2.0), 0.02);
  scenario.plan += "[effects.presliding]\nlength_mm = 2.0\n";
  EXPECT_NEAR(visibility_of(scenario).at(0), std::sqrt(2.0), 0.02);
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

/// Six sessions of a drive that works in both directions, which differ in nothing.
Scenario two_sided_preload(const std::string& noise) {
  Scenario scenario;
  scenario.seed = 3;
  scenario.kind = CampaignKind::one;
  scenario.design = Design::two_sided;
  scenario.hidden.push_back({"friction_preload", false, {{"force_N", {2}}}, {}});
  scenario.plan = R"(
[campaign]
name = "both ways"
two_sided = true
[model.sheath]
friction_coefficient = 0.02
bend_angle_deg = 180.0
[recordings]
bend_angles_deg = 180.0
output_means_N = 0.0
output_amplitudes_N = 40.0
frequencies_Hz = 0.5
travels_mm = 40.0
load_frequency_ratio = 7.3
repeats = 6
sample_rate_Hz = 50.0
duration_s = 20.0
channels = ["input_tension_N", "output_tension_N", "tendon_velocity_m_s", "bend_angle_deg"]
[effects.friction_preload]
force_N = 2.0
[noise]
)" + noise;
  return scenario;
}

// Friction F s beside that of the sheath, phi |T| s, where T is a sine: of s is left
// 1 - mean(|T|)^2 / mean(T^2) = 1 - 8 / pi^2. 6000 samples; noise of both ends 0.3 and 0.4 N. The
// gain takes up next to nothing, for T changes its sign as often as not.
TEST(Visibility, OfForcesOfEitherSignByHand) {
  const Scenario scenario = two_sided_preload("output_absolute_N = 0.3\ninput_absolute_N = 0.4\n");
  const double expected = 2 / 0.5 * std::sqrt(6000 * (1 - 8 / (3.14159265 * 3.14159265)));
  EXPECT_NEAR(visibility_of(scenario).at(0), expected, 0.04 * expected);
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
