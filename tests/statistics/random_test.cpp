#include "host_sim/statistics/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "host_sim/statistics/replicates.hpp"
#include "tests/statistics/simulation.hpp"

namespace host_sim::statistics {
namespace {

TEST(Random, RepeatsItself) {
  Random first(1, 2, 3);
  Random second(1, 2, 3);
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(first.uniform(), second.uniform());
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
