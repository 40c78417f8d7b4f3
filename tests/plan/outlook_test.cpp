#include "host_sim/plan/outlook.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>

#include "tests/plan/theory.hpp"

namespace host_sim::plan {
namespace {

using testing::kPaperLaw;
using testing::paper_design;
using testing::standard_error_of_ln_b10;

Outlook outlook(const Design& design, double use_tension_N, std::size_t simulations = 100,
                double assurance = 0.8) {
  return look_out(kPaperLaw, design, {.use_tension_N = use_tension_N, .assurance = assurance},
                  {.simulations = simulations});
}

double ratio_of_theory(const Design& design, double use_tension_N) {
  const double z = boost::math::quantile(boost::math::normal(), 0.975);
  return 2 * z * standard_error_of_ln_b10(design, kPaperLaw, use_tension_N);
}

// ln (high / low) of a large campaign against 2 * 1.96 standard errors. The estimate of the shape
// moves it by 0.78 / sqrt(n) from campaign to campaign, 0.3 % in the median of these.
TEST(Outlook, HasTheWidthOfLargeSamples) {
  const Design design = paper_design(150);
  for (const double use_tension_N : {25.5, 55.0}) {
    EXPECT_NEAR(std::log(outlook(design, use_tension_N).ratio_median) /
                    ratio_of_theory(design, use_tension_N),
                1, 0.015)
        << use_tension_N;
  }
}

TEST(Outlook, HasTheWidthOfLargeSamplesUnderSuspension) {
  // Two thirds of the lowest level outlast it, a third of the next, and hardly one of the highest.
  const Design design = paper_design(150, kPaperLaw.quantile(1.0 / 3, 42.5));
  EXPECT_NEAR(std::log(outlook(design, 25.5).ratio_median) / ratio_of_theory(design, 25.5), 1,
              0.02);
}

TEST(Outlook, NarrowsWithSpecimens) {
  EXPECT_GT(outlook(paper_design(10), 25.5).ratio_at_assurance,
            outlook(paper_design(20), 25.5).ratio_at_assurance);
}

TEST(Outlook, WidensWithSuspension) {
  EXPECT_GT(outlook(paper_design(20, 600), 25.5).ratio_median,
            outlook(paper_design(20), 25.5).ratio_median);
}

TEST(Outlook, WidensWithExtrapolation) {
  EXPECT_GT(outlook(paper_design(20), 25.5).ratio_median,
            outlook(paper_design(20), 35.0).ratio_median);
}

TEST(Outlook, WidensWithAssurance) {
  const Outlook low = outlook(paper_design(10), 25.5, 100, 0.5);
  EXPECT_EQ(low.ratio_at_assurance, low.ratio_median);
  EXPECT_GT(outlook(paper_design(10), 25.5, 100, 0.9).ratio_at_assurance, low.ratio_at_assurance);
}

TEST(Outlook, CountsTheCampaignsWithinTheRatio) {
  const Design design = paper_design(10);
  const double ratio_at_80 = outlook(design, 25.5).ratio_at_assurance;
  const auto share_within = [&](double ratio) {
    return look_out(kPaperLaw, design, {.use_tension_N = 25.5, .ratio = ratio},
                    {.simulations = 100})
        .share_within;
  };
  EXPECT_DOUBLE_EQ(share_within(ratio_at_80), 0.8);
  EXPECT_DOUBLE_EQ(share_within(ratio_at_80 * (1 - 1e-9)), 0.79);
}

TEST(Outlook, HoldsTheTruthAsOftenAsItSays) {
  // 400 campaigns: 95 % within 3 binomial errors of 1.1 %.
  EXPECT_NEAR(outlook(paper_design(20), 25.5, 400).coverage, 0.95, 0.033);
}

TEST(Outlook, TellsWhatTheLevelsTake) {
  const Outlook result = outlook(paper_design(5), 25.5, 400);
  ASSERT_EQ(result.levels.size(), 4U);
  EXPECT_EQ(result.specimens(), 20U);
  EXPECT_DOUBLE_EQ(result.failures(), 20);
  EXPECT_NEAR(result.levels[0].cycles, 5 * kPaperLaw.mean_life(42.5), 1e-6);
  // The longest of n Weibull lives has quantile function alpha (-ln(1 - p^(1/n)))^(1/beta); its
  // mean by the median of each hundredth of p.
  double longest = 0;
  for (int i = 0; i < 100; ++i) {
    longest += kPaperLaw.quantile(std::pow((i + 0.5) / 100, 1.0 / 5), 42.5) / 100;
  }
  EXPECT_NEAR(result.levels[0].longest_cycles / longest, 1, 0.02);
}

TEST(Outlook, OfATestThatNobodyFailsInHasNoInterval) {
  const Outlook result = outlook(paper_design(5, 1), 25.5);
  EXPECT_EQ(result.no_interval, 1);
  EXPECT_TRUE(std::isinf(result.ratio_at_assurance));
  EXPECT_FALSE(result.reaches({.use_tension_N = 25.5, .ratio = 1e6}));
}

TEST(Outlook, IsTheSameForAnyNumberOfThreads) {
  const Goal goal{.use_tension_N = 25.5};
  const Outlook one =
      look_out(kPaperLaw, paper_design(8), goal, {.simulations = 100, .threads = 1});
  const Outlook five =
      look_out(kPaperLaw, paper_design(8), goal, {.simulations = 100, .threads = 5});
  EXPECT_EQ(one.ratio_median, five.ratio_median);
  EXPECT_EQ(one.ratio_at_assurance, five.ratio_at_assurance);
  EXPECT_EQ(one.coverage, five.coverage);
  EXPECT_EQ(one.levels[1].longest_cycles, five.levels[1].longest_cycles);
}

TEST(Outlook, ChangesWithTheSeed) {
  const Goal goal{.use_tension_N = 25.5};
  EXPECT_NE(
      look_out(kPaperLaw, paper_design(8), goal, {.simulations = 100, .seed = 1}).ratio_median,
      look_out(kPaperLaw, paper_design(8), goal, {.simulations = 100, .seed = 2}).ratio_median);
}

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
