#include "host_sim/reference/equations.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <boost/math/distributions/weibull.hpp>
#include <cmath>
#include <limits>
#include <numbers>

namespace host_sim::reference {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Equations, CapstanEfficiencyIsOneWithoutABendOrFriction) {
  EXPECT_EQ(capstan_efficiency(0.128, 0.0), 1.0);
  EXPECT_EQ(capstan_efficiency(0.0, 3.0), 1.0);
}

TEST(Equations, CapstanEfficiencyHalvesForEachLnTwo) {
  EXPECT_DOUBLE_EQ(capstan_efficiency(0.1, 10 * std::numbers::ln2), 0.5);
  EXPECT_DOUBLE_EQ(capstan_efficiency(0.1, 20 * std::numbers::ln2), 0.25);
}

// Efficiency 1/2: the output swings from 32 to 48 N, so that the input peaks at 48 / 0.5 = 96 N
// while pulling and falls to 32 * 0.5 = 16 N while releasing; mean 56 N, amplitude 40 N.
TEST(Equations, InputTensionRangeSpansPullingAtThePeakToReleasingAtTheTrough) {
  const MeanAmplitude input = input_tension_range({.mean_N = 40, .amplitude_N = 8}, 0.5);
  EXPECT_DOUBLE_EQ(input.mean_N, 56.0);
  EXPECT_DOUBLE_EQ(input.amplitude_N, 40.0);
}

TEST(Equations, InputTensionRangeIsTheOutputsWithoutFriction) {
  const MeanAmplitude input = input_tension_range({.mean_N = 40, .amplitude_N = 8}, 1.0);
  EXPECT_EQ(input.mean_N, 40.0);
  EXPECT_EQ(input.amplitude_N, 8.0);
}

RC_GTEST_PROP(Equations, InputTensionRangeAgreesWithTheDirections, ()) {
  const double mean_N = 0.1 * *rc::gen::inRange(0, 2000);
  const double amplitude_N = 0.1 * *rc::gen::inRange(0, 2000);
  const double efficiency = 0.01 * *rc::gen::inRange(1, 101);
  const MeanAmplitude input = input_tension_range({mean_N, amplitude_N}, efficiency);
  const double peak_N =
      input_tension_from_output(mean_N + amplitude_N, efficiency, Direction::kPulling);
  const double trough_N =
      input_tension_from_output(mean_N - amplitude_N, efficiency, Direction::kReleasing);
  RC_ASSERT(std::abs(input.mean_N + input.amplitude_N - peak_N) <= 1e-13 * (1 + peak_N));
  RC_ASSERT(std::abs(input.mean_N - input.amplitude_N - trough_N) <= 1e-13 * (1 + peak_N));
}

TEST(Equations, FrictionAddsWhilePullingAndHelpsWhileReleasing) {
  EXPECT_DOUBLE_EQ(input_tension_from_output(40, 0.8, Direction::kPulling), 50.0);
  EXPECT_DOUBLE_EQ(input_tension_from_output(40, 0.8, Direction::kReleasing), 32.0);
}

TEST(Equations, DirectionFollowsTheVelocityAndStaysAtRest) {
  EXPECT_EQ(direction_of(0.1, Direction::kReleasing), Direction::kPulling);
  EXPECT_EQ(direction_of(-0.1, Direction::kPulling), Direction::kReleasing);
  EXPECT_EQ(direction_of(0.0, Direction::kPulling), Direction::kPulling);
  EXPECT_EQ(direction_of(-0.0, Direction::kReleasing), Direction::kReleasing);
}

// 0.05 Nm/A * (3 - 1) A * 10 * 0.8 / 0.02 m = 40 N.
TEST(Equations, InputTensionFromCurrent) {
  const Drive drive{.torque_constant_Nm_per_A = 0.05,
                    .gear_ratio = 10,
                    .gear_efficiency = 0.8,
                    .spool_radius_m = 0.02,
                    .current_offset_A = 1};
  EXPECT_DOUBLE_EQ(input_tension_from_current(3, drive), 40.0);
  EXPECT_EQ(input_tension_from_current(1, drive), 0.0);
  EXPECT_DOUBLE_EQ(input_tension_from_current(-1, drive), -40.0);
}

// 32 / (1 - 0.6^2) = 32 / 0.64 = 50.
TEST(Equations, GerberRaisesTheAmplitudeByTheMean) {
  EXPECT_DOUBLE_EQ(gerber_effective_tension({60, 32}, 100), 50.0);
  EXPECT_DOUBLE_EQ(gerber_effective_tension({-60, 32}, 100), 50.0);
  EXPECT_EQ(gerber_effective_tension({0, 32}, 100), 32.0);
}

TEST(Equations, GerberIsZeroWithoutAmplitudeAndInfiniteAtTheUltimateMean) {
  EXPECT_EQ(gerber_effective_tension({60, 0}, 100), 0.0);
  EXPECT_EQ(gerber_effective_tension({100, 0}, 100), 0.0);
  EXPECT_EQ(gerber_effective_tension({100, 1}, 100), kInfinity);
  EXPECT_EQ(gerber_effective_tension({-120, 1}, 100), kInfinity);
}

TEST(Equations, InversePowerLaw) {
  EXPECT_DOUBLE_EQ(ipl_life_cycles(10, 5e4, 3), 50.0);
  EXPECT_EQ(ipl_life_cycles(0, 5e4, 3), kInfinity);
}

TEST(Equations, WeibullAtTheCharacteristicLifeAndAtNone) {
  for (const double shape : {0.5, 1.0, 5.94}) {
    EXPECT_DOUBLE_EQ(weibull_survival(1.0, shape), 1 / std::numbers::e);
    EXPECT_EQ(weibull_survival(0.0, shape), 1.0);
  }
}

// Gamma(2) = 1, Gamma(3) = 2, Gamma(3/2) = sqrt(pi)/2.
TEST(Equations, WeibullMeanWhereGammaIsKnown) {
  EXPECT_DOUBLE_EQ(weibull_mean_damage(1.0), 1.0);
  EXPECT_DOUBLE_EQ(weibull_mean_damage(0.5), 2.0);
  EXPECT_DOUBLE_EQ(weibull_mean_damage(2.0), std::sqrt(std::numbers::pi) / 2);
}

TEST(Equations, WeibullQuantileOfTheExponentialDistribution) {
  EXPECT_EQ(weibull_life_damage(0.0, 1.0), 0.0);
  EXPECT_DOUBLE_EQ(weibull_life_damage(0.5, 1.0), std::numbers::ln2);
}

RC_GTEST_PROP(Equations, WeibullAgreesWithBoost, ()) {
  const double shape = 0.01 * *rc::gen::inRange(50, 2000);
  const double fraction = 0.001 * *rc::gen::inRange(1, 1000);
  const boost::math::weibull_distribution<> expected(shape, 1.0);
  const double damage = boost::math::quantile(expected, fraction);
  RC_ASSERT(std::abs(weibull_life_damage(fraction, shape) / damage - 1) < 1e-12);
  RC_ASSERT(std::abs(weibull_survival(damage, shape) - (1 - fraction)) < 1e-12);
  RC_ASSERT(std::abs(weibull_mean_damage(shape) / boost::math::mean(expected) - 1) < 1e-12);
}

// beta 2: sqrt(1 + ln 2) - 1 = 0.3012099 from 1 on. beta 1 does not age. The paper's wire at its
// B10 is at 10 % risk where D^beta has doubled: B10 (2^(1/5.94) - 1) = 0.0847407.
TEST(Equations, WeibullGivenSurvivalWhereItIsKnown) {
  EXPECT_NEAR(weibull_further_damage(1.0, 0.5, 2.0), 0.3012099, 5e-8);
  EXPECT_DOUBLE_EQ(weibull_further_damage(17.0, 0.5, 1.0), std::numbers::ln2);
  EXPECT_DOUBLE_EQ(weibull_further_damage(0.0, 0.1, 5.94), weibull_life_damage(0.1, 5.94));
  EXPECT_DOUBLE_EQ(weibull_further_damage(1e-200, 0.1, 5.94), weibull_life_damage(0.1, 5.94));
  EXPECT_EQ(weibull_further_damage(0.0, 0.0, 5.94), 0.0);
  EXPECT_EQ(weibull_further_damage(0.3, 0.0, 5.94), 0.0);
  const double b10 = weibull_life_damage(0.1, 5.94);
  EXPECT_NEAR(weibull_further_damage(b10, 0.1, 5.94), 0.0847407, 5e-8);
  EXPECT_NEAR(weibull_break_risk(b10, 0.0847407447, 5.94), 0.1, 1e-9);
  EXPECT_DOUBLE_EQ(weibull_break_risk(3.0, std::numbers::ln2, 1.0), 0.5);
  EXPECT_DOUBLE_EQ(weibull_break_risk(0.0, 1.0, 5.94), 1 - 1 / std::numbers::e);
  EXPECT_EQ(weibull_break_risk(0.4, 0.0, 5.94), 0.0);
}

// Where nothing cancels: 1 - R(D + d) / R(D).
RC_GTEST_PROP(Equations, WeibullGivenSurvivalIsTheRatioOfSurvivals, ()) {
  const double shape = 0.01 * *rc::gen::inRange(50, 2000);
  const double damage = 0.001 * *rc::gen::inRange(0, 1200);
  const double further = 0.001 * *rc::gen::inRange(1, 1000);
  const double ratio = weibull_survival(damage + further, shape) / weibull_survival(damage, shape);
  const double risk = weibull_break_risk(damage, further, shape);
  RC_ASSERT(std::abs(risk - (1 - ratio)) < 1e-12);
  RC_PRE(risk > 1e-6 && risk < 0.999);
  RC_ASSERT(std::abs(weibull_further_damage(damage, risk, shape) / further - 1) < 1e-9);
}

}  // namespace
}  // namespace host_sim::reference
