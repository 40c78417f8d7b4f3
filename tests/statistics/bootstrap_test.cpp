#include "host_sim/statistics/bootstrap.hpp"

#include <Random123/philox.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <set>
#include <vector>

#include "host_sim/statistics/random.hpp"
#include "tests/statistics/samples.hpp"

namespace host_sim::statistics {
namespace {

constexpr Distribution kLives{.family = Family::weibull, .first = 100, .second = 2};
constexpr double kLong = 1e9;

/// What is seen of specimens that would live for ever: their limits, or kLong.
std::vector<double> limits(const CensoringPlan& plan, std::size_t count, Random& random) {
  Sample seen;
  plan.observe(std::vector<double>(count, kLong), random, seen);
  std::vector<double> result;
  for (const Observation& specimen : seen) {
    EXPECT_EQ(specimen.failed, specimen.value == kLong);
    result.push_back(specimen.value);
  }
  return result;
}

TEST(CensoringPlan, NothingSuspendedNothingWillBe) {
  Random random(1, 2, 3);
  EXPECT_EQ(limits(CensoringPlan(failed({5, 6})), 2, random), (std::vector<double>{kLong, kLong}));
}

TEST(CensoringPlan, ATestThatEndedEndsThereForAll) {
  Random random(1, 2, 3);
  EXPECT_EQ(limits(CensoringPlan(with_suspended({5, 6}, {8, 8})), 4, random),
            (std::vector<double>{8, 8, 8, 8}));
}

TEST(CensoringPlan, ATestThatEndedWithAFailureEndsThereForAll) {
  Random random(1, 2, 3);
  EXPECT_EQ(limits(CensoringPlan(with_suspended({5, 8}, {8, 8})), 4, random),
            (std::vector<double>{8, 8, 8, 8}));
}

TEST(CensoringPlan, NoLimitIsKnownBeyondTheLast) {
  Random random(1, 2, 3);
  EXPECT_EQ(limits(CensoringPlan(with_suspended({9}, {4})), 2, random),
            (std::vector<double>{kLong, 4}));
}

TEST(CensoringPlan, SuspendedSpecimensKeepTheirLimit) {
  Random random(1, 2, 3);
  const CensoringPlan plan(with_suspended({1, 2}, {3, 5, 7}));
  for (int i = 0; i < 100; ++i) {
    const std::vector<double> drawn = limits(plan, 5, random);
    EXPECT_EQ((std::vector<double>(drawn.begin() + 2, drawn.end())),
              (std::vector<double>{3, 5, 7}));
  }
}

// Limits 3 and 6: four specimens are at risk at 3 and two at 6, so that the limits survive with 3/4
// and then 3/8. The failure at 2 has limit 3 with 1/4, 6 with 3/8; that at 4 had a limit of at
// least 4, so 6 with (3/4 - 3/8) / (3/4) = 1/2; that at 9 none.
TEST(CensoringPlan, FailuresGetLimitsNotBelowTheirLife) {
  Random random(1, 2, 3);
  const CensoringPlan plan(with_suspended({2, 4, 9}, {3, 6}));
  constexpr int kDraws = 20'000;
  int at_three = 0;
  int at_six = 0;
  int later_at_three = 0;
  int later_at_six = 0;
  for (int i = 0; i < kDraws; ++i) {
    const std::vector<double> drawn = limits(plan, 5, random);
    at_three += drawn[0] == 3 ? 1 : 0;
    at_six += drawn[0] == 6 ? 1 : 0;
    later_at_three += drawn[1] == 3 ? 1 : 0;
    later_at_six += drawn[1] == 6 ? 1 : 0;
    EXPECT_EQ(drawn[2], kLong);
  }
  // Within five standard errors.
  EXPECT_NEAR(at_three / double{kDraws}, 1.0 / 4, 0.016);
  EXPECT_NEAR(at_six / double{kDraws}, 3.0 / 8, 0.018);
  EXPECT_EQ(later_at_three, 0);
  EXPECT_NEAR(later_at_six / double{kDraws}, 1.0 / 2, 0.018);
}

TEST(CensoringPlan, DrawsLivesOfTheDistribution) {
  constexpr std::size_t kCount = 20'000;
  const CensoringPlan plan(Sample(kCount, {.value = 1, .failed = true}));
  Random random(7, 0, 0);
  Sample drawn;
  plan.draw(kLives, random, drawn);
  const auto below_median = std::count_if(drawn.begin(), drawn.end(), [](const Observation& seen) {
    return seen.value < 100 * std::sqrt(std::log(2));
  });
  EXPECT_NEAR(static_cast<double>(below_median) / kCount, 0.5, 0.018);
}

TEST(CensoringPlan, ObservesTheShorterOfLifeAndLimit) {
  const CensoringPlan plan(with_suspended({5, 6}, {8, 8}));
  Random random(1, 2, 3);
  Sample seen;
  plan.observe(std::vector<double>{7, 8, 9, 1}, random, seen);
  const std::vector<double> expected{7, 8, 8, 1};
  const std::vector<bool> failed_ones{true, true, false, true};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(seen[i].value, expected[i]);
    EXPECT_EQ(seen[i].failed, failed_ones[i]);
  }
}

TEST(Random, RepeatsItself) {
  Random first(1, 2, 3);
  Random second(1, 2, 3);
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(first.uniform(), second.uniform());
  }
}

// philox4x64-10 of counter and key 0 among the vectors that come with Random123.
TEST(Random, BeginsWithThePublishedBlock) {
  Random random(0, 0, 0);
  for (const std::uint64_t word :
       {0x16554d9eca36314cU, 0xdb20fe9d672d0fdcU, 0xd7e772cee186176bU, 0x7e68b68aec7ba23bU}) {
    EXPECT_EQ(random.uniform(), (static_cast<double>(word >> 11U) + 0.5) * 0x1p-53);
  }
}

TEST(Random, CountsBlocksAndReplicatesUnderTheKeyOfSeedAndStream) {
  using Philox = r123::Philox4x64;
  std::mt19937_64 any(5);
  for (int i = 0; i < 200; ++i) {
    const std::uint64_t seed = any();
    const std::uint64_t stream = any();
    const std::uint64_t number = any();
    Random random(seed, stream, number);
    for (std::uint64_t block = 0; block < 5; ++block) {
      for (const std::uint64_t word :
           Philox{}(Philox::ctr_type{{block, number, 0, 0}}, Philox::key_type{{seed, stream}})) {
        ASSERT_EQ(random.uniform(), (static_cast<double>(word >> 11U) + 0.5) * 0x1p-53);
      }
    }
  }
}

TEST(Random, SeedStreamAndNumberEachMakeAnother) {
  std::set<double> firsts;
  for (std::uint64_t i = 0; i < 50; ++i) {
    firsts.insert(Random(i, 1000, 2000).uniform());
    firsts.insert(Random(1000, i, 2000).uniform());
    firsts.insert(Random(1000, 2000, i).uniform());
    firsts.insert(Random(1000, 2000, (i + 1) << 32U).uniform());
  }
  EXPECT_EQ(firsts.size(), 200U);
}

TEST(Random, FirstNumbersOfReplicatesAreUniform) {
  const auto firsts = simulated(5000, [](Random& random) { return random.uniform(); });
  EXPECT_LT(distance_from_uniform(firsts), 1.95);
  EXPECT_GT(*std::min_element(firsts.begin(), firsts.end()), 0);
  EXPECT_LT(*std::max_element(firsts.begin(), firsts.end()), 1);
}

TEST(Replicates, EachOnceWhateverTheThreads) {
  for (const unsigned threads : {1U, 4U}) {
    std::vector<int> calls(123);
    for_each_replicate({.replicates = calls.size(), .threads = threads},
                       [&] { return [&](Random&, std::size_t i) { ++calls[i]; }; });
    EXPECT_EQ(calls, std::vector<int>(123, 1));
  }
}

TEST(Replicates, DrawNumbersOfTheirOwn) {
  std::vector<double> drawn(123);
  for_each_replicate({.replicates = drawn.size()}, [&] {
    return [&](Random& random, std::size_t i) { drawn[i] = random.uniform(); };
  });
  EXPECT_EQ(std::set<double>(drawn.begin(), drawn.end()).size(), drawn.size());
}

TEST(Replicates, NoneHaveNoP) {
  EXPECT_TRUE(std::isnan(bootstrap_p({}, 1)));
}

// Of three that could be computed two are not below 2.
TEST(Replicates, PCountsTheObservedToo) {
  const std::vector<double> drawn{1, 2, std::nan(""), 3};
  EXPECT_DOUBLE_EQ(bootstrap_p(drawn, 2), 3.0 / 4);
  EXPECT_TRUE(std::isnan(bootstrap_p(drawn, std::nan(""))));
}

}  // namespace
}  // namespace host_sim::statistics
