#include "host_sim/replay/given_survival.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace host_sim {
namespace {

Model::Life life_of(double shape) {
  return {.mean_stress = Model::MeanStress::kGerber,
          .ipl_scale = 1.53e5,
          .ipl_exponent = 1.38,
          .weibull_shape = shape};
}

/// A wire that does not age, its life known within a factor of 2 at 40 N, the exponent to +-1.
Model::Life known_life() {
  Model::Life life = life_of(1);
  life.interval = Model::Life::Interval{.level = 0.95,
                                        .ipl_scale = {1e5, 2e5},
                                        .ipl_exponent = {0.38, 2.38},
                                        .weibull_shape = {1, 1},
                                        .pivot_tension_N = 40,
                                        .life_at_pivot = {500, 2000}};
  return life;
}

void expect_interval(const Estimate& estimate, double low, double value, double high) {
  EXPECT_NEAR(estimate.value, value, 1e-4 * value);
  ASSERT_TRUE(estimate.interval);
  EXPECT_NEAR((*estimate.interval)[0], low, 1e-4 * low);
  EXPECT_NEAR((*estimate.interval)[1], high, 1e-4 * high);
}

// A wire at B10 = 0.684648 of the paper's shape has 0.0847407, 0.278179 and 0.474797 left to 10, 50
// and 90 % (tests/lifemodel/conditional_test.cpp).
TEST(GivenSurvival, OfThePapersWireAtItsB10) {
  const GivenSurvival given = given_survival({.used = 0.684648495, .horizon = horizon_from("2h")},
                                             0.02, 3600 / 2.118518, 40, life_of(5.94));
  EXPECT_NEAR(given.to_10.value, 4.237037, 1e-5);
  EXPECT_NEAR(given.to_50.value, 13.90897, 1e-4);
  EXPECT_NEAR(given.to_90.value, 23.73984, 1e-4);
  EXPECT_FALSE(given.to_10.interval);
  // Two hours are 4.237 repeats: 10 %.
  ASSERT_TRUE(given.risk);
  EXPECT_NEAR(given.risk->repeats, 4.237036, 1e-6);
  EXPECT_NEAR(given.risk->probability.value, 0.1, 1e-6);
  EXPECT_EQ(given.level, 0);
}

// -ln 0.9 / 0.01 = 10.536 repeats whatever was used, and in proportion to the life. 1 - exp(-0.1),
// exp(-0.2), exp(-0.05).
TEST(GivenSurvival, HasTheIntervalOfTheLife) {
  for (const double used : {0.0, 0.4, 3.0}) {
    const GivenSurvival given =
        given_survival({.used = used, .horizon = horizon_from("10")}, 0.01, 60, 40, known_life());
    expect_interval(given.to_10, 5.26803, 10.53605, 21.07210);
    ASSERT_TRUE(given.risk);
    expect_interval(given.risk->probability, 0.0487706, 0.0951626, 0.181269);
    EXPECT_EQ(given.level, 0.95);
  }
}

// At e times the pivot the exponent's 1 is added as a root of squares: exp(hypot(ln 2, 1))
// = 3.37616.
TEST(GivenSurvival, IsLessSureFarFromThePivot) {
  const GivenSurvival given =
      given_survival({.used = 0.4, .horizon = {}}, 0.01, 60, 40 * std::exp(1.0), known_life());
  expect_interval(given.to_10, 10.53605 / 3.37616, 10.53605, 10.53605 * 3.37616);
  EXPECT_FALSE(given.risk);
}

TEST(GivenSurvival, OfAProfileWithoutDamageIsUnlimited) {
  const GivenSurvival given =
      given_survival({.used = 0.4, .horizon = horizon_from("8h")}, 0, 60, 0, known_life());
  EXPECT_TRUE(std::isinf(given.to_10.value));
  EXPECT_EQ(given.risk->probability.value, 0);
}

// Without ageing the risk after 230.26 repeats is 90 %, 68.4 % at twice the life and 99 % at half
// of it, whatever was used; the curve ends at 99 %, where a new wire is too.
TEST(BreakCurve, HasTheRiskWithTheIntervalOfTheLife) {
  const BreakCurve curve = break_curve(0.4, 0.01, 40, known_life());
  ASSERT_EQ(curve.repeats.size(), 201U);
  ASSERT_EQ(curve.broken.size(), 201U);
  EXPECT_EQ(curve.repeats.front(), 0);
  EXPECT_EQ(curve.broken.front().value, 0);
  EXPECT_NEAR(curve.repeats.back(), 460.517, 1e-3);
  EXPECT_NEAR(curve.repeats[100], 230.2585, 1e-4);
  expect_interval(curve.broken[100], 0.683772, 0.9, 0.99);
  EXPECT_NEAR(curve.broken_new[100], 0.9, 1e-9);
}

// Whole at B10 of the paper's shape: 99 % at (0.105361 + 4.605170)^(1 / 5.94) - 0.684648 =
// 0.613461. Within three times that is the 1.150745 at which 90 % of new wires have broken: it goes
// so far.
TEST(BreakCurve, ReachesTheLifeOfANewWire) {
  const BreakCurve curve = break_curve(0.684648495, 0.02, 40, life_of(5.94));
  EXPECT_NEAR(curve.repeats.back(), 1.150745 / 0.02, 1e-3);
  EXPECT_NEAR(curve.broken_new.back(), 0.9, 1e-6);
  EXPECT_FALSE(curve.broken.back().interval);
  // Three times as far does not, where 99 % is at (11.1169 + 4.605170)^(1 / 5.94) - 1.5 =
  // 0.0901292.
  EXPECT_NEAR(break_curve(1.5, 0.02, 40, life_of(5.94)).repeats.back(), 3 * 0.0901292 / 0.02, 1e-2);
}

TEST(BreakCurve, OfNoDamageIsEmpty) {
  EXPECT_TRUE(break_curve(0.4, 0, 0, known_life()).repeats.empty());
}

TEST(Horizon, IsRepeatsOrHoursAboveNone) {
  EXPECT_EQ(horizon_from("200")->value, 200);
  EXPECT_FALSE(horizon_from("200")->in_hours);
  EXPECT_EQ(horizon_from("0.5h")->value, 0.5);
  EXPECT_TRUE(horizon_from("0.5h")->in_hours);
  for (const char* bad : {"", "h", "0", "0h", "-3", "nan", "inf", "8 h", "8hh", "8d", "1e999"}) {
    EXPECT_FALSE(horizon_from(bad)) << bad;
  }
}

}  // namespace
}  // namespace host_sim
