#include "host_sim/calibrate/damage.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace host_sim::calibrate {
namespace {

// alpha is 100 cycles at 10 N and 25 at 20 N.
constexpr life_law::LifeLaw kLaw{10'000, 2, 2};

TEST(Damage, AddsTheSharesOfEachBlock) {
  EXPECT_DOUBLE_EQ(damage({{{10, 50}, {20, 5}}, true, 0}, kLaw), 0.5 + 0.2);
}

TEST(Damage, MeanIsTheAverageWhereAllFailed) {
  const life_law::LifeData data{{{{10, 50}}, true, 0}, {{{20, 25}}, true, 0}};
  EXPECT_DOUBLE_EQ(mean_damage(data, kLaw), 0.75);
}

TEST(Damage, MeanWithSuspendedIsByMaximumLikelihood) {
  const life_law::LifeData data{{{{10, 60}}, true, 0}, {{{10, 80}}, false, 0}};
  // scale = sqrt((0.36 + 0.64) / 1), mean = scale * Gamma(1.5) = sqrt(pi) / 2.
  EXPECT_NEAR(mean_damage(data, kLaw), std::sqrt(std::acos(-1.0)) / 2, 1e-15);
}

TEST(Damage, MeanWithoutFailureIsNotANumber) {
  const life_law::LifeData data{{{{10, 60}}, false, 0}};
  EXPECT_TRUE(std::isnan(mean_damage(data, kLaw)));
}

}  // namespace
}  // namespace host_sim::calibrate
