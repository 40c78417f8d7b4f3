#include "host_sim/plan/search.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <numeric>

#include "tests/plan/theory.hpp"

namespace host_sim::plan {
namespace {

/// ln ratio = c / sqrt(n), whose least n is (c / ln ratio)^2, rounded up.
struct Counted {
  double c;
  int calls = 0;

  double operator()(std::size_t n) {
    ++calls;
    return std::exp(c / std::sqrt(static_cast<double>(n)));
  }
};

TEST(LeastTotal, IsWhereTheRatioIsReached) {
  // (2 / ln 1.25)^2 = 80.33.
  Counted ratio{2};
  EXPECT_EQ(least_total(3, 400, 1.25, std::ref(ratio)), 81U);
  EXPECT_LE(ratio.calls, 6);
}

TEST(LeastTotal, IsTheFirstAllowedOneWhereThatIsEnough) {
  Counted ratio{0.01};
  EXPECT_EQ(least_total(3, 400, 1.25, std::ref(ratio)), 4U);
}

TEST(LeastTotal, SaysWhereThereIsNone) {
  Counted ratio{20};
  EXPECT_EQ(least_total(3, 400, 1.25, std::ref(ratio)), 401U);
  EXPECT_LE(ratio.calls, 4);
}

TEST(LeastTotal, PassesTotalsWithoutAnInterval) {
  const auto ratio = [](std::size_t n) {
    return n < 30 ? std::numeric_limits<double>::infinity() : 1.2;
  };
  EXPECT_EQ(least_total(3, 400, 1.25, ratio), 30U);
}

RC_GTEST_PROP(LeastTotal, FindsAnyStep, ()) {
  const auto low = *rc::gen::inRange<std::size_t>(0, 20);
  const auto high = low + *rc::gen::inRange<std::size_t>(1, 500);
  const auto step = *rc::gen::inRange<std::size_t>(0, 600);
  const double above = *rc::gen::element(1.2500001, 1.3, 2.0, 1e9);
  const double below = *rc::gen::element(1.0000001, 1.2, 1.25);
  int calls = 0;
  const std::size_t found = least_total(low, high, 1.25, [&](std::size_t n) {
    RC_ASSERT(n > low);
    RC_ASSERT(n <= high);
    RC_ASSERT(++calls < 40);
    return n < step ? above : below;
  });
  RC_ASSERT(found == std::max(low + 1, std::min(step, high + 1)));
}

TEST(LeastSpecimens, AreTheLeastThatReachTheGoal) {
  const Conditions conditions{testing::kPaperLaw, {42.5, 50.7, 60.0, 70.8}};
  const Allocation equal{"equal", {1, 1, 1, 1}};
  const Goal goal{.use_tension_N = 35, .ratio = 1.3, .assurance = 0.8};
  const SimulationOptions options{.simulations = 100};
  const Found found = least_specimens(conditions, equal, goal, 200, options);
  ASSERT_TRUE(found.reached);
  EXPECT_LE(found.outlook.ratio_at_assurance, 1.3);
  EXPECT_EQ(found.outlook.specimens(), found.design.specimens());
  const Design fewer = design_of(conditions, equal, found.design.specimens() - 1);
  EXPECT_GT(look_out(conditions.law, fewer, goal, options).ratio_at_assurance, 1.3);
}

TEST(LeastSpecimens, AreTheMostAllowedWhereTheGoalIsOutOfReach) {
  const Conditions conditions{testing::kPaperLaw, {42.5, 50.7, 60.0, 70.8}};
  const Goal goal{.use_tension_N = 10, .ratio = 1.01, .assurance = 0.8};
  const Found found =
      least_specimens(conditions, {"equal", {1, 1, 1, 1}}, goal, 20, {.simulations = 100});
  EXPECT_FALSE(found.reached);
  EXPECT_EQ(found.outlook.specimens(), 20U);
  EXPECT_GT(found.outlook.ratio_at_assurance, 1.01);
}

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
