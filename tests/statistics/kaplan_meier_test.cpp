#include "host_sim/statistics/kaplan_meier.hpp"

#include <gtest/gtest.h>

#include <array>

#include "tests/statistics/samples.hpp"

namespace host_sim::statistics {
namespace {

KaplanMeier estimate_of(const Sample& sample) {
  KaplanMeier estimate;
  estimate.assign(sample);
  return estimate;
}

// Maintained group of acute myelogenous leukaemia: Miller, Survival Analysis (1981), p. 49; R
// package survival prints these survivals for its data set aml.
TEST(KaplanMeier, MaintainedLeukaemia) {
  const KaplanMeier estimate =
      estimate_of(with_suspended({9, 13, 18, 23, 31, 34, 48}, {13, 28, 45, 161}));
  constexpr std::array<double, 7> kSurvival{0.909, 0.818, 0.716, 0.614, 0.491, 0.368, 0.184};
  ASSERT_EQ(estimate.steps().size(), kSurvival.size());
  double before = 0;
  for (std::size_t i = 0; i < kSurvival.size(); ++i) {
    EXPECT_NEAR(1 - estimate.steps()[i].after, kSurvival[i], 0.0005);
    EXPECT_DOUBLE_EQ(estimate.steps()[i].before, before);
    before = estimate.steps()[i].after;
  }
  EXPECT_EQ(estimate.last(), 161);
  EXPECT_FALSE(estimate.complete());
}

TEST(KaplanMeier, FailuresAloneAreTheirEmpiricalDistribution) {
  const KaplanMeier estimate = estimate_of(failed({3, 1, 2, 2}));
  ASSERT_EQ(estimate.steps().size(), 3U);
  EXPECT_EQ(estimate.steps()[1].value, 2);
  EXPECT_DOUBLE_EQ(estimate.steps()[1].before, 0.25);
  EXPECT_DOUBLE_EQ(estimate.steps()[1].after, 0.75);
  EXPECT_TRUE(estimate.complete());
}

// Of the three at risk at 2 one fails; the one suspended there was still at risk.
TEST(KaplanMeier, SuspendedAtALifeAreAtRiskForFailuresThere) {
  const KaplanMeier estimate = estimate_of(with_suspended({1, 2}, {2, 3}));
  EXPECT_DOUBLE_EQ(estimate.steps()[1].after, 0.5);
}

TEST(KaplanMeier, ForgetsTheSampleBefore) {
  KaplanMeier estimate = estimate_of(failed({3, 1, 2, 2}));
  estimate.assign(with_suspended({}, {7}));
  EXPECT_TRUE(estimate.steps().empty());
  EXPECT_EQ(estimate.size(), 1);
  EXPECT_EQ(estimate.last(), 7);
}

}  // namespace
}  // namespace host_sim::statistics
