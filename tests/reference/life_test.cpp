#include "host_sim/reference/life.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "host_sim/reference/equations.hpp"

namespace host_sim::reference {
namespace {

constexpr Constants kRound{.ultimate_tension_N = 100,
                           .hysteresis_N = 0,
                           .ipl_scale = 25'000,
                           .ipl_exponent = 2,
                           .weibull_shape = 1};

TEST(Life, MarksOfTheExponentialDistribution) {
  const LifePoints damage = damage_to(1.0);
  EXPECT_DOUBLE_EQ(damage.b10, std::log(10.0 / 9.0));
  EXPECT_DOUBLE_EQ(damage.b50, std::numbers::ln2);
  EXPECT_DOUBLE_EQ(damage.mean, 1.0);
  EXPECT_DOUBLE_EQ(damage.b90, std::numbers::ln10);
}

TEST(Life, SurvivalAtTheMarks) {
  const LifePoints damage = damage_to(5.94);
  EXPECT_DOUBLE_EQ(weibull_survival(damage.b10, 5.94), 0.9);
  EXPECT_DOUBLE_EQ(weibull_survival(damage.b50, 5.94), 0.5);
  EXPECT_DOUBLE_EQ(weibull_survival(damage.b90, 5.94), 0.1);
}

TEST(Life, RepeatsAreDamageOverDamage) {
  const LifePoints repeats = repeats_to(0.02, 1.0);
  EXPECT_DOUBLE_EQ(repeats.b50, 50 * std::numbers::ln2);
  EXPECT_DOUBLE_EQ(repeats.mean, 50.0);
}

TEST(Life, AHarmlessProfileCanBeRepeatedForEver) {
  const LifePoints repeats = repeats_to(0.0, 5.94);
  for (const double mark : {repeats.b10, repeats.b50, repeats.mean, repeats.b90}) {
    EXPECT_EQ(mark, std::numeric_limits<double>::infinity());
  }
}

// 28 to 92 N is T_eff = 50 N however often it is repeated, half cycles included.
TEST(Life, EquivalentTensionOfOneKindOfCycleIsItsOwn) {
  Reference reference(kRound);
  reference.push(28);
  EXPECT_EQ(equivalent_effective_tension(reference.reading(), kRound), 0.0);
  for (const double tension_N : {92.0, 28.0, 92.0, 28.0, 92.0, 28.0}) {
    reference.push(tension_N);
    EXPECT_DOUBLE_EQ(equivalent_effective_tension(reference.reading(), kRound), 50.0);
  }
  EXPECT_EQ(equivalent_cycles(reference.reading()), 3.0);
}

// gamma = 2: sqrt((30^2 + 40^2) / 2) and 1 / sqrt((1/30^2 + 1/40^2) / 2) = 1200 / sqrt(1250).
TEST(Life, MixesArePowerMeans) {
  const std::array<TensionShare, 2> mix{{{30, 0.5}, {40, 0.5}}};
  EXPECT_DOUBLE_EQ(mix_by_damage(mix, 2), std::sqrt(1250.0));
  EXPECT_DOUBLE_EQ(mix_by_life(mix, 2), 1200.0 / std::sqrt(1250.0));
}

}  // namespace
}  // namespace host_sim::reference
