#include "host_sim/report/calibrate/scale_interval.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace host_sim::calibrate_page {
namespace {

/// The share at a height of the Weibull axis.
double share_at(double place) {
  return -std::expm1(-std::exp(place));
}

TEST(ScaleInterval, IsStraightOnProbabilityPaper) {
  // A quarter of the way from -1 to 3: 16 (81/16)^(1/4) = 24 and 1 (16)^(1/4) = 2.
  const auto interval = scale_interval({{share_at(-1), share_at(3)}, {1, 16}, {16, 81}});
  ASSERT_TRUE(interval.has_value());
  EXPECT_NEAR(interval->low, 2, 1e-7);
  EXPECT_NEAR(interval->high, 24, 1e-7);
}

TEST(ScaleInterval, TakesAPointOfTheBandThatIsThere) {
  const auto interval =
      scale_interval({{share_at(-2), share_at(0), share_at(1)}, {1, 5, 9}, {2, 7, 11}});
  ASSERT_TRUE(interval.has_value());
  EXPECT_NEAR(interval->low, 5, 1e-9);
  EXPECT_NEAR(interval->high, 7, 1e-9);
}

TEST(ScaleInterval, NeedsABandThatReachesThere) {
  EXPECT_FALSE(scale_interval({}).has_value());
  EXPECT_FALSE(scale_interval({{share_at(-2), share_at(-1)}, {1, 5}, {2, 7}}).has_value());
}

}  // namespace
}  // namespace host_sim::calibrate_page
