#include "host_sim/life_law/life_simulation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "host_sim/life_law/life_fit.hpp"
#include "tests/life_law/data_sets.hpp"

namespace host_sim::life_law {
namespace {

using statistics::Random;
using testing::kPaperLaw;

LifeData drawn_like(const LifeData& data, std::uint64_t number, const LifeLaw& law = kPaperLaw) {
  LifeData drawn;
  Random random(5, 7, number);
  LifeSimulation(data).draw(law, random, drawn);
  return drawn;
}

double damage(const LifeDatum& datum, const LifeLaw& law) {
  double sum = 0;
  for (const LifeDatum::Block& block : datum.blocks) {
    sum += block.cycles / law.characteristic_life(block.effective_tension_N);
  }
  return sum;
}

TEST(LifeSimulation, KeepsLoadsAndLevels) {
  const LifeData data = testing::paper_like(1, 3);
  const LifeData drawn = drawn_like(data, 0);
  ASSERT_EQ(drawn.size(), data.size());
  for (std::size_t i = 0; i < data.size(); ++i) {
    EXPECT_EQ(drawn[i].level, data[i].level);
    EXPECT_EQ(drawn[i].blocks.front().effective_tension_N,
              data[i].blocks.front().effective_tension_N);
    EXPECT_NE(drawn[i].blocks.front().cycles, data[i].blocks.front().cycles);
    EXPECT_TRUE(drawn[i].failed);
  }
}

TEST(LifeSimulation, TheSameNumberIsTheSameCampaign) {
  const LifeData data = testing::paper_like(1, 3);
  const LifeSimulation simulation(data);
  LifeData first;
  LifeData again;
  for (const std::uint64_t number : {3U, 4U, 3U}) {
    Random random(5, 7, number);
    again.swap(first);
    simulation.draw(kPaperLaw, random, first);
  }
  const LifeData alone = drawn_like(data, 3);
  for (std::size_t i = 0; i < data.size(); ++i) {
    EXPECT_EQ(first[i].blocks.front().cycles, alone[i].blocks.front().cycles);
    EXPECT_NE(first[i].blocks.front().cycles, again[i].blocks.front().cycles);
  }
}

TEST(LifeSimulation, ATestThatEndedAtOneLifeEndsThereAgain) {
  const LifeData data = testing::suspended_at(testing::paper_like(2, 30), 700);
  for (const LifeDatum& datum : drawn_like(data, 1)) {
    EXPECT_LE(datum.blocks.front().cycles, datum.level < 2 ? 700 : 2000);
    EXPECT_EQ(datum.failed, datum.blocks.front().cycles != 700);
  }
}

// Damage at failure has the mean Gamma(1 + 1 / beta) and the median (ln 2)^(1 / beta).
TEST(LifeSimulation, SpecimensInBlocksFailByTheirDamage) {
  LifeData data(4000, LifeDatum{.blocks = {{40, 300}, {60, 100}, {50, 1}}, .failed = true});
  double sum = 0;
  std::size_t below_median = 0;
  for (const LifeDatum& datum : drawn_like(data, 2)) {
    EXPECT_TRUE(datum.failed);
    const double at_failure = damage(datum, kPaperLaw);
    sum += at_failure;
    below_median += at_failure < std::pow(std::log(2), 1 / kPaperLaw.shape) ? 1U : 0U;
  }
  // Standard errors: 0.18 / sqrt(4000) = 0.003 and sqrt(1000) = 32.
  EXPECT_NEAR(sum / 4000, std::tgamma(1 + 1 / kPaperLaw.shape), 0.012);
  EXPECT_NEAR(static_cast<double>(below_median), 2000, 130);
}

TEST(LifeSimulation, AFailureInAnEarlierBlockEndsThere) {
  const LifeDatum long_lived{.blocks = {{40, 1e5}, {60, 100}}, .failed = true};
  const LifeData drawn = drawn_like(LifeData{long_lived}, 3);
  ASSERT_EQ(drawn[0].blocks.size(), 1U);
  EXPECT_TRUE(drawn[0].failed);
  EXPECT_LT(drawn[0].blocks[0].cycles, 1e5);
}

TEST(LifeSimulation, ASuspendedSpecimenInBlocksIsSuspendedAtItsEndUnlessItFails) {
  const LifeData data(2000, LifeDatum{.blocks = {{40, 500}, {60, 150}}, .failed = false});
  const double end = damage(data.front(), kPaperLaw);
  std::size_t failed = 0;
  for (const LifeDatum& datum : drawn_like(data, 4)) {
    failed += datum.failed ? 1U : 0U;
    if (!datum.failed) {
      EXPECT_EQ(datum.blocks.size(), 2U);
      EXPECT_EQ(damage(datum, kPaperLaw), end);
    } else {
      EXPECT_LT(damage(datum, kPaperLaw), end);
    }
  }
  const double expected = 2000 * (1 - std::exp(-std::pow(end, kPaperLaw.shape)));
  EXPECT_NEAR(static_cast<double>(failed), expected, 4 * std::sqrt(expected));
}

/// Mean and standard error of what `number` campaigns estimate.
struct Mean {
  void add(double value) {
    sum += value;
    squares += value * value;
    ++count;
  }
  [[nodiscard]] double mean() const { return sum / count; }
  [[nodiscard]] double error() const {
    return std::sqrt((squares / count - mean() * mean()) / count);
  }
  double sum = 0, squares = 0, count = 0;
};

/// The likelihood of accumulated damage finds the law again in specimens that ran in blocks only.
TEST(LifeSimulation, BlocksRecoverTheLaw) {
  Mean exponent;
  Mean ln_alpha_at_60_N;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const LifeFit fit = fit_life(testing::in_blocks(seed, 60, 0.25));
    ASSERT_EQ(fit.problem, statistics::FitProblem::none);
    exponent.add(fit.law().exponent);
    ln_alpha_at_60_N.add(std::log(fit.law().characteristic_life(60)));
  }
  EXPECT_NEAR(exponent.mean(), 1.38, 4 * exponent.error());
  EXPECT_NEAR(ln_alpha_at_60_N.mean(), std::log(kPaperLaw.characteristic_life(60)),
              4 * ln_alpha_at_60_N.error() + 0.003);
  EXPECT_LT(exponent.error(), 0.03);
}

TEST(LifeSimulation, LevelsAreInspectedAndTrimmedAsTheyWere) {
  LifeData data(10, LifeDatum{.blocks = {{50, 700}}, .level = 0, .from_cycles = 600.0});
  data.resize(20, LifeDatum{.blocks = {{40, 900}}, .level = 1});
  data[18] = {.blocks = {{40, 900}}, .level = 1, .from_cycles = 0.0, .trimmed = true};
  data[19] = {.blocks = {{40, 900}}, .failed = false, .level = 1, .trimmed = true};
  const LifeData drawn = drawn_like(data, 5);
  double lowest = HUGE_VAL;
  double highest = 0;
  std::size_t trimmed = 0;
  for (const LifeDatum& datum : drawn) {
    const double cycles = datum.blocks.front().cycles;
    if (datum.level == 0) {
      EXPECT_EQ(cycles, std::round(cycles / 100) * 100);
      EXPECT_EQ(*datum.from_cycles, cycles - 100);
    } else if (!datum.trimmed) {
      lowest = std::min(lowest, cycles);
      highest = std::max(highest, cycles);
    }
  }
  for (const LifeDatum& datum : drawn) {
    if (datum.trimmed) {
      EXPECT_EQ(datum.blocks.front().cycles, datum.failed ? lowest : highest);
      ++trimmed;
    }
  }
  EXPECT_EQ(trimmed, 2U);
}

}  // namespace
}  // namespace host_sim::life_law
