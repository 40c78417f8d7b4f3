#include "tests/blind/scoring/proportion.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace blind::test {
namespace {

TEST(Proportion, NoneOfSomeHasTheBoundsOfTheRuleOfThree) {
  const Proportion none{0, 1000};
  EXPECT_EQ(none.lower(), 0);
  // (1 - p)^1000 = 0.025
  EXPECT_NEAR(none.upper(), 1 - std::pow(0.025, 1e-3), 1e-9);
}

TEST(Proportion, AllOfSomeIsItsMirrorImage) {
  const Proportion all{20, 20};
  EXPECT_EQ(all.upper(), 1);
  EXPECT_NEAR(all.lower(), std::pow(0.025, 1.0 / 20), 1e-9);
}

// Clopper and Pearson's own chart, and R's binom.test(7, 20): 0.1539092 .. 0.5921885.
TEST(Proportion, SevenOfTwenty) {
  const Proportion seven{7, 20};
  EXPECT_NEAR(seven.lower(), 0.1539092, 1e-6);
  EXPECT_NEAR(seven.upper(), 0.5921885, 1e-6);
}

TEST(Proportion, NoneOfNoneSaysNothing) {
  const Proportion nothing;
  EXPECT_TRUE(std::isnan(nothing.value()));
  EXPECT_EQ(nothing.lower(), 0);
  EXPECT_EQ(nothing.upper(), 1);
  EXPECT_EQ(text_of(nothing), "-");
}

// Sums of binomials: fewer than 51 of 60 at 0.904 have 0.0586, fewer than 52 0.1181; fewer than 48
// at 0.865 have 0.0547, fewer than 49 0.1033.
TEST(Proportion, ASampleHasToReachMostOfIt) {
  EXPECT_EQ((Proportion{904, 1000}.least_of(60)), 51u);
  EXPECT_EQ((Proportion{865, 1000}.least_of(60)), 48u);
  EXPECT_EQ((Proportion{10, 10}.least_of(60)), 60u);
  EXPECT_EQ((Proportion{0, 10}.least_of(60)), 0u);
}

TEST(Proportion, CountsWhatItIsTold) {
  Proportion proportion;
  proportion.add(true);
  proportion.add(false);
  proportion.add(true);
  proportion.add(true);
  EXPECT_EQ(proportion.value(), 0.75);
}

}  // namespace
}  // namespace blind::test
