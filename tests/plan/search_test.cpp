#include "host_sim/plan/search.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

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

}  // namespace
}  // namespace host_sim::plan
