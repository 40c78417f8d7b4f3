#include "host_sim/plan/curvature.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/plan/theory.hpp"

namespace host_sim::plan {
namespace {

using testing::kPaperLaw;
using testing::paper_design;
using testing::power_to_see_bend;

std::vector<double> bend_of(const Curvature& curvature, const Design& design) {
  const Truth straight = truth_under(kPaperLaw, design);
  const Truth bent = truth_under(kPaperLaw, curvature, design);
  std::vector<double> bend;
  for (std::size_t i = 0; i < design.levels.size(); ++i) {
    bend.push_back(
        std::log(bent.characteristic_life_cycles[i] / straight.characteristic_life_cycles[i]));
  }
  return bend;
}

TEST(Curvature, BendsBetweenTheExtremes) {
  // In octaves of 10 N: levels at 1, 2, 3 and the use at 0. (x - 1)(x - 3) is 3 at 0 and -1 at 2,
  // so half the life at the use is 2^(1/3) of it in the middle.
  const Design design{{{20, 1}, {40, 1}, {80, 1}}};
  const auto bend = bend_of({.use_tension_N = 10, .factor = 2}, design);
  EXPECT_NEAR(bend[0], 0, 1e-12);
  EXPECT_NEAR(bend[1], std::log(2) / 3, 1e-12);
  EXPECT_NEAR(bend[2], 0, 1e-12);
}

TEST(Curvature, IsThatOfTheTestedLevels) {
  const Design design{{{20, 1}, {40, 1}, {80, 1}, {160, 0}}};
  const auto bend = bend_of({.use_tension_N = 10, .factor = 2}, design);
  EXPECT_NEAR(bend[1], std::log(2) / 3, 1e-12);
  EXPECT_NEAR(bend[2], 0, 1e-12);
}

TEST(Curvature, IsAtTheMiddleWhereTheUseIsBetweenTheLevels) {
  const Design design{{{20, 1}, {40, 1}, {80, 1}}};
  for (const double use_tension_N : {20.0, 33.0, 80.0}) {
    const auto bend = bend_of({.use_tension_N = use_tension_N, .factor = 1.5}, design);
    EXPECT_NEAR(bend[0], 0, 1e-12);
    EXPECT_NEAR(bend[1], -std::log(1.5), 1e-12);
  }
}

TEST(PowerToSee, IsNoneWithTwoLevels) {
  EXPECT_FALSE(
      power_to_see({25.5, 2}, kPaperLaw, {{{42.5, 50}, {70.8, 50}}}, {.simulations = 100}));
  EXPECT_FALSE(power_to_see({25.5, 2}, kPaperLaw, {{{42.5, 50}, {60, 0}, {70.8, 50}}},
                            {.simulations = 100}));
}

TEST(PowerToSee, IsThatOfTheNoncentralChiSquare) {
  for (const std::size_t specimens : {30U, 100U}) {
    const Design design = paper_design(specimens);
    const Curvature curvature{.use_tension_N = 25.5, .factor = 2};
    const auto power = power_to_see(curvature, kPaperLaw, design, {.simulations = 400});
    ASSERT_TRUE(power);
    // Three binomial errors of 400 campaigns, twice: the critical value is simulated too.
    EXPECT_NEAR(*power, power_to_see_bend(design, kPaperLaw, bend_of(curvature, design)), 0.1);
  }
}

TEST(PowerToSee, IsTheSignificanceWithoutCurvature) {
  const auto power =
      power_to_see({25.5, 1 + 1e-9}, kPaperLaw, paper_design(10), {.simulations = 200});
  ASSERT_TRUE(power);
  EXPECT_NEAR(*power, 0.05, 0.0051);
}

TEST(PowerToSee, IsTheSameForAnyNumberOfThreads) {
  const Curvature curvature{25.5, 3};
  EXPECT_EQ(
      power_to_see(curvature, kPaperLaw, paper_design(8), {.simulations = 100, .threads = 1}),
      power_to_see(curvature, kPaperLaw, paper_design(8), {.simulations = 100, .threads = 3}));
}

}  // namespace
}  // namespace host_sim::plan
