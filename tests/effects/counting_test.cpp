#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "host_sim/effects/counting_effect.hpp"

namespace host_sim::effects {
namespace {

/// An ultimate tension so high that Gerber leaves the amplitude as it is.
constexpr reference::Constants kLinear{.ultimate_tension_N = 1e9,
                                       .hysteresis_N = 3,
                                       .ipl_scale = 1e6,
                                       .ipl_exponent = 1.38,
                                       .weibull_shape = 5.94};

const CountingEffect& counting(std::string_view id) {
  for (const auto& effect : counting_effects()) {
    if (effect->id() == id) {
      return *effect;
    }
  }
  throw std::out_of_range("no such effect");
}

recording::Covariates with_tension(std::vector<double> tension_N) {
  recording::Covariates c;
  c.time_s.resize(tension_N.size());
  c.input_tension_N = std::move(tension_N);
  return c;
}

TEST(Undersampling, TenSamplesACycleLoseOneLessTheCosineOfEighteenDegrees) {
  std::vector<double> tension_N;
  for (int k = 0; k <= 640 * 5; ++k) {
    tension_N.push_back(10 * std::sin(2 * std::numbers::pi * k / 640));
  }
  const double left = std::pow(std::cos(std::numbers::pi / 10), 1.38);
  EXPECT_NEAR(counting("undersampling").damage_lost(with_tension(tension_N), kLinear, 64), 1 - left,
              1e-9);
  EXPECT_EQ(counting("undersampling").damage_lost(with_tension(tension_N), kLinear, 1), 0);
}

/// Swings of 20 N with one of 2 N on the way down of each.
std::vector<double> large_with_small() {
  std::vector<double> tension_N;
  for (int k = 0; k < 50; ++k) {
    tension_N.insert(tension_N.end(), {10, -1, 1, -10});
  }
  tension_N.push_back(10);
  return tension_N;
}

TEST(SmallCycles, ATenthOfTheAmplitudeCostsFourPercentOfAFullOne) {
  const double small = 0.041686938;  // 0.1^1.38
  const CountingEffect& effect = counting("small_cycles");
  const recording::Covariates c = with_tension(large_with_small());
  EXPECT_NEAR(effect.damage_lost(c, kLinear, 2.1), small / (1 + small), 1e-8);
  EXPECT_EQ(effect.damage_lost(c, kLinear, 1.9), 0);
  EXPECT_EQ(effect.damage_lost(c, kLinear, 50), 1);
}

TEST(Counting, NothingIsLostOfNothing) {
  for (const auto& effect : counting_effects()) {
    EXPECT_EQ(effect->damage_lost(with_tension({5, 5, 5}), kLinear, 2), 0) << effect->id();
  }
}

TEST(Counting, NeedsAnInputTension) {
  for (const auto& effect : counting_effects()) {
    EXPECT_NE(effect->missing({}), "") << effect->id();
    EXPECT_EQ(effect->missing(with_tension({1, 2})), "") << effect->id();
  }
}

}  // namespace
}  // namespace host_sim::effects
