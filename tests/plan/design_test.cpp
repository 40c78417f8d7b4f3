#include "host_sim/plan/design.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace host_sim::plan {
namespace {

constexpr double kForever = std::numeric_limits<double>::infinity();

// alpha is 1000 cycles at 10 N.
LifeLaw law(double shape) {
  return {.scale = 1e5, .exponent = 2, .shape = shape};
}

TEST(Design, CountsSpecimensAndTestedLevels) {
  const Design design{{{10, 3}, {20, 0}, {30, 4}}};
  EXPECT_EQ(design.specimens(), 7U);
  EXPECT_EQ(design.tested_levels(), 2U);
}

TEST(ExpectedFailures, AreAllWithoutSuspension) {
  EXPECT_DOUBLE_EQ(expected_failures({10, 8}, kForever, law(3)), 8);
}

TEST(ExpectedFailures, FollowTheWeibullDistribution) {
  // 1 - exp(-(500 / 1000)^2) of 10.
  EXPECT_NEAR(expected_failures({10, 10}, 500, law(2)), 2.2119921692859513, 1e-12);
  // At the characteristic life, whatever the shape: 1 - 1/e.
  EXPECT_NEAR(expected_failures({10, 1}, 1000, law(5.94)), 1 - std::exp(-1), 1e-12);
}

TEST(ExpectedCycles, AreTheMeanLifeWithoutSuspension) {
  EXPECT_NEAR(expected_cycles({10, 4}, kForever, law(1)), 4000, 1e-9);
  // Gamma(3/2) = sqrt(pi) / 2.
  EXPECT_NEAR(expected_cycles({10, 1}, kForever, law(2)), 500 * std::sqrt(M_PI), 1e-9);
}

TEST(ExpectedCycles, AreTheRestrictedMeanUnderSuspension) {
  // Exponential lives: alpha (1 - exp(-c / alpha)).
  EXPECT_NEAR(expected_cycles({10, 3}, 700, law(1)), 3000 * (1 - std::exp(-0.7)), 1e-9);
  // Shape 2 up to alpha: alpha times the integral of exp(-x^2), sqrt(pi) erf(1) / 2.
  EXPECT_NEAR(expected_cycles({10, 1}, 1000, law(2)), 500 * std::sqrt(M_PI) * std::erf(1), 1e-9);
}

TEST(ExpectedCycles, ComeToTheMeanLifeWithLateSuspension) {
  EXPECT_NEAR(expected_cycles({10, 5}, 1e5, law(4)), expected_cycles({10, 5}, kForever, law(4)),
              1e-9);
}

}  // namespace
}  // namespace host_sim::plan
