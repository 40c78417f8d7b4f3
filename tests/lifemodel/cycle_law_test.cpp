#include "lifemodel/damage/cycle_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support.hpp"

namespace lifemodel {
namespace {

using lifemodel_test::cycle_damage;
using lifemodel_test::newtons;
using lifemodel_test::paper_constants;
using lifemodel_test::parameters_of;
using pack::to_double;

TEST(CycleLaw, PaperAt360Degrees) {
  // 49 N at 360 deg: eta = exp(-0.128 * 2 pi) = 0.447424; T_in 109.5157 and 21.9238 N,
  // T_a 43.7960, T_m 65.7198, T_eff = 43.7960 / (1 - 0.370461^2) = 50.7627, N = 1.53e5 / T_eff^1.38
  const auto law = parameters_of(paper_constants()).law;
  EXPECT_NEAR(1 / to_double(law(newtons(109.5157), newtons(21.9238))), 677.70, 0.02);
}

TEST(CycleLaw, WithinTheStatedErrorForEveryExponentAndStress) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  double worst = 0;
  double worst_with_rounding = 0;
  int tried = 0;
  while (tried < 300'000) {
    auto constants = paper_constants();
    constants.ultimate_tension_N = std::pow(1e6, uniform(random));
    constants.ipl_exponent = 1 + 11 * uniform(random);
    const double high_N = constants.ultimate_tension_N * uniform(random);
    const double low_N = constants.ultimate_tension_N * (1.9 * uniform(random) - 0.95);
    const double effective =
        std::fabs(high_N - low_N) / 2 /
        (1 - std::pow((high_N + low_N) / 2 / constants.ultimate_tension_N, 2)) /
        constants.ultimate_tension_N;
    if (low_N >= high_N || effective < 0.02 || effective > 0.95) {
      continue;
    }
    ++tried;
    // 20 cycles of life at the ultimate tension.
    constants.ipl_scale = 20 * std::pow(constants.ultimate_tension_N, constants.ipl_exponent);
    const auto law = parameters_of(constants).law;
    const Tension high = pack::tension(high_N, constants.ultimate_tension_N);
    const Tension low = pack::tension(low_N, constants.ultimate_tension_N);
    const double ours = to_double(law(high, low));
    const auto of_steps =
        static_cast<double>(cycle_damage(constants, to_double(high) * constants.ultimate_tension_N,
                                         to_double(low) * constants.ultimate_tension_N));
    const auto of_newtons = static_cast<double>(cycle_damage(constants, high_N, low_N));
    worst = std::max(worst, std::fabs(ours / of_steps - 1));
    worst_with_rounding = std::max(worst_with_rounding, std::fabs(ours / of_newtons - 1));
  }
  EXPECT_LE(worst, 2e-6);
  EXPECT_LE(worst_with_rounding, 2e-5);
  RecordProperty("worst_relative_error", std::to_string(worst));
  std::printf("worst relative error %.2e, with the rounding of tensions %.2e\n", worst,
              worst_with_rounding);
}

TEST(CycleLaw, WideningACycleByOneStepNeverLowersItsDamage) {
  std::mt19937 random(11);
  for (int i = 0; i < 300'000; ++i) {
    auto constants = paper_constants();
    constants.ipl_exponent = 1 + 11.0 * (i % 100) / 100;
    const auto law = parameters_of(constants).law;
    const std::int32_t ultimate = kUltimate.raw();
    std::uniform_int_distribution<std::int32_t> tension(-ultimate + 2, ultimate - 2);
    std::int32_t low = tension(random);
    // Half of the cycles are small: there one step is many steps of the logarithm.
    std::int32_t high = i % 2 == 0 ? tension(random) : std::min(low + 1 + i % 5000, ultimate - 2);
    if (low == high) {
      continue;
    }
    if (low > high) {
      std::swap(low, high);
    }
    const auto damage = [&](std::int32_t x, std::int32_t y) {
      Damage sum;
      Flags flags;
      sum.add(law(Tension::from_raw(x), Tension::from_raw(y)), flags);
      return sum;
    };
    const Damage narrow = damage(low, high);
    ASSERT_LE(narrow, damage(low, high + 1)) << low << " " << high;
    ASSERT_LE(narrow, damage(low - 1, high)) << low << " " << high;
    ASSERT_EQ(narrow, damage(high, low));
  }
}

TEST(CycleLaw, ReachingTheUltimateTensionIsAWholeLife) {
  const auto law = parameters_of(paper_constants()).law;
  const Tension ultimate = kUltimate;
  const auto just_below = Tension::from_raw(kUltimate.raw() - 1);
  EXPECT_EQ(to_double(law(ultimate, newtons(170))), 1);
  EXPECT_EQ(to_double(law(newtons(-177.5), newtons(0))), 1);
  EXPECT_EQ(to_double(law(Tension::highest(), Tension::lowest())), 1);
  EXPECT_LT(to_double(law(just_below, newtons(170))), 1e-2);
}

TEST(CycleLaw, NoCycleTakesMoreThanAWholeLife) {
  auto constants = paper_constants();
  constants.ipl_scale = 10;
  EXPECT_EQ(to_double(parameters_of(constants).law(newtons(100), newtons(0))), 1);
}

TEST(CycleLaw, TheSmallestCycleIsNotNothing) {
  auto constants = paper_constants();
  constants.ipl_exponent = 12;
  constants.ipl_scale = 1e30;
  const auto law = parameters_of(constants).law;
  Damage sum;
  Flags flags;
  sum.add(law(Tension::from_raw(0), Tension::from_raw(1)), flags);
  EXPECT_EQ(sum.words(), (Damage::Words{2, 0, 0, 0}));
  sum.add(law(Tension::from_raw(0), Tension::from_raw(1)).half(), flags);
  EXPECT_EQ(sum.words(), (Damage::Words{3, 0, 0, 0}));
}

}  // namespace
}  // namespace lifemodel
