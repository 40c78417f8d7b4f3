#include "host_sim/plan/allocation.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <numeric>

namespace host_sim::plan {
namespace {

using Counts = std::vector<std::size_t>;

const Allocation* named(const std::vector<Allocation>& allocations, const std::string& name) {
  for (const Allocation& allocation : allocations) {
    if (allocation.name == name) {
      return &allocation;
    }
  }
  return nullptr;
}

TEST(StandardAllocations, GiveFourTwoOneToThreeLevels) {
  const auto allocations = standard_allocations(std::array{40.0, 50.0, 60.0}, 30);
  const Allocation* low = named(allocations, "more at low");
  ASSERT_NE(low, nullptr);
  EXPECT_DOUBLE_EQ(low->weights[0] / low->weights[2], 4);
  EXPECT_DOUBLE_EQ(low->weights[1] / low->weights[2], 2);
}

TEST(StandardAllocations, WeighExtremesByTheDistanceOfTheOther) {
  // The use is one octave below the lowest level and two below the highest: 2 to 1.
  const auto allocations = standard_allocations(std::array{50.0, 70.0, 100.0}, 25);
  const Allocation* extremes = named(allocations, "extremes");
  ASSERT_NE(extremes, nullptr);
  EXPECT_NEAR(extremes->weights[0] / extremes->weights[2], 2, 1e-12);
  EXPECT_EQ(extremes->weights[1], 0);
}

TEST(StandardAllocations, TestBothExtremesEvenWhereTheUseIsOneOfThem) {
  const auto allocations = standard_allocations(std::array{50.0, 100.0}, 50);
  const Allocation* extremes = named(allocations, "extremes");
  ASSERT_NE(extremes, nullptr);
  EXPECT_GT(extremes->weights[1], 0);
  EXPECT_GT(extremes->weights[0], extremes->weights[1]);
}

TEST(StandardAllocations, CheckNearTheMiddleInLogTension) {
  // The middle of 40 and 90 is 60 in ln T, and 65 in T.
  const auto allocations = standard_allocations(std::array{40.0, 58.0, 65.0, 90.0}, 30);
  const Allocation* check = named(allocations, "extremes + check");
  ASSERT_NE(check, nullptr);
  EXPECT_DOUBLE_EQ(check->weights[1], 0.2);
  EXPECT_EQ(check->weights[2], 0);
  EXPECT_NEAR(check->weights[0] + check->weights[3], 0.8, 1e-12);
}

TEST(StandardAllocations, NeedNoMiddleWithTwoLevels) {
  const auto allocations = standard_allocations(std::array{40.0, 90.0}, 30);
  EXPECT_EQ(allocations.size(), 3U);
  EXPECT_EQ(named(allocations, "extremes + check"), nullptr);
}

TEST(ShareOut, FollowsTheWeights) {
  const Allocation allocation{"", {4, 2, 1}};
  EXPECT_EQ(share_out(allocation, 14), (Counts{8, 4, 2}));
  EXPECT_EQ(share_out(allocation, 70), (Counts{40, 20, 10}));
  EXPECT_EQ(share_out({"", {1, 1, 1, 1}}, 80), (Counts{20, 20, 20, 20}));
  EXPECT_EQ(share_out({"", {2, 0, 1}}, 30), (Counts{20, 0, 10}));
  // 8.25 and 2.75, to the nearest.
  EXPECT_EQ(share_out({"", {3, 1}}, 11), (Counts{8, 3}));
}

TEST(ShareOut, StartsWithTwoAtEachTestedLevel) {
  const Allocation allocation{"", {0.9, 0, 0.05, 0.05}};
  EXPECT_EQ(fewest_specimens(allocation), 6U);
  EXPECT_EQ(share_out(allocation, 6), (Counts{2, 0, 2, 2}));
}

RC_GTEST_PROP(ShareOut, SharesAllAndNeverTakesAway, ()) {
  const auto parts = *rc::gen::container<std::vector<int>>(rc::gen::inRange(1, 50));
  RC_PRE(!parts.empty() && parts.size() < 8);
  Allocation allocation;
  allocation.weights.assign(parts.begin(), parts.end());
  const auto total = fewest_specimens(allocation) + *rc::gen::inRange<std::size_t>(0, 100);
  const Counts counts = share_out(allocation, total);
  const Counts more = share_out(allocation, total + 1);
  RC_ASSERT(std::accumulate(counts.begin(), counts.end(), std::size_t{0}) == total);
  for (std::size_t i = 0; i < counts.size(); ++i) {
    RC_ASSERT(more[i] >= counts[i]);
    RC_ASSERT(counts[i] >= kFewestOfLevel);
  }
}

}  // namespace
}  // namespace host_sim::plan
