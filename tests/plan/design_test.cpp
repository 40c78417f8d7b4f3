#include "host_sim/plan/design.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/plan/theory.hpp"

namespace host_sim::plan {
namespace {

using life_law::LifeData;
using life_law::LifeDatum;
using testing::kPaperLaw;

LifeData drawn(const Design& design, std::uint64_t number, std::uint64_t seed = 1) {
  return simulated_campaign(design, truth_under(kPaperLaw, design), seed, number);
}

TEST(Truth, IsTheLawAtEachLevel) {
  const Design design{{{10, 1}, {20, 1}}};
  const Truth truth = truth_under({.scale = 1000, .exponent = 2, .shape = 3}, design);
  EXPECT_DOUBLE_EQ(truth.characteristic_life_cycles[0], 10);
  EXPECT_DOUBLE_EQ(truth.characteristic_life_cycles[1], 2.5);
  EXPECT_EQ(truth.shape, 3);
}

TEST(SimulatedCampaign, HasTheSpecimensOfTheDesign) {
  const LifeData data = drawn({{{42.5, 3}, {50, 0}, {60, 2}}}, 0);
  ASSERT_EQ(data.size(), 5U);
  EXPECT_EQ(data[2].blocks.at(0).effective_tension_N, 42.5);
  EXPECT_EQ(data[2].level, 0U);
  EXPECT_EQ(data[3].blocks.at(0).effective_tension_N, 60);
  EXPECT_EQ(data[3].level, 2U);
  EXPECT_TRUE(std::all_of(data.begin(), data.end(), [](const LifeDatum& d) { return d.failed; }));
}

TEST(SimulatedCampaign, KeepsASpecimenInEveryDesignThatHasIt) {
  const LifeData few = drawn({{{42.5, 3}, {60, 2}}}, 7);
  const LifeData many = drawn({{{42.5, 30}, {60, 20}}}, 7);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(few[k].blocks[0].cycles, many[k].blocks[0].cycles);
  }
  EXPECT_EQ(few[3].blocks[0].cycles, many[30].blocks[0].cycles);
  EXPECT_EQ(few[4].blocks[0].cycles, many[31].blocks[0].cycles);
}

TEST(SimulatedCampaign, DiffersByNumberSeedAndLevel) {
  const Design design{{{42.5, 1}, {42.6, 1}}};
  const double life = drawn(design, 0)[0].blocks[0].cycles;
  EXPECT_NE(life, drawn(design, 1)[0].blocks[0].cycles);
  EXPECT_NE(life, drawn(design, 0, 2)[0].blocks[0].cycles);
  EXPECT_GT(std::abs(life / drawn(design, 0)[1].blocks[0].cycles - 1), 0.01);
}

TEST(SimulatedCampaign, SuspendsWhatLastsTooLong) {
  const double limit = kPaperLaw.quantile(0.5, 42.5);
  const LifeData whole = drawn({{{42.5, 200}}}, 3);
  const LifeData cut = drawn({{{42.5, 200}}, limit}, 3);
  std::size_t suspended = 0;
  for (std::size_t i = 0; i < cut.size(); ++i) {
    const double life = whole[i].blocks[0].cycles;
    EXPECT_EQ(cut[i].failed, life <= limit);
    EXPECT_EQ(cut[i].blocks[0].cycles, std::min(life, limit));
    suspended += cut[i].failed ? 0U : 1U;
  }
  EXPECT_NEAR(static_cast<double>(suspended), 100, 4 * std::sqrt(50));
}

TEST(SimulatedCampaign, HasLivesOfTheLaw) {
  // Largest distance from the distribution; 1.95 / sqrt(n) is exceeded once in a thousand.
  constexpr std::size_t kSpecimens = 2000;
  std::vector<double> p;
  for (const LifeDatum& datum : drawn({{{50, kSpecimens}}}, 5)) {
    const double ratio = datum.blocks[0].cycles / kPaperLaw.characteristic_life(50);
    p.push_back(-std::expm1(-std::pow(ratio, kPaperLaw.shape)));
  }
  std::sort(p.begin(), p.end());
  double distance = 0;
  for (std::size_t i = 0; i < kSpecimens; ++i) {
    const double expected = (static_cast<double>(i) + 0.5) / static_cast<double>(kSpecimens);
    distance = std::max(distance, std::abs(p[i] - expected));
  }
  EXPECT_LT(distance, 1.95 / std::sqrt(static_cast<double>(kSpecimens)));
}

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
