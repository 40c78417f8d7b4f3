#include "host_sim/report/replay/life_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace host_sim {
namespace {

TEST(LifeCurve, IsTheWeibullDistributionOfTheRepeats) {
  // Shape 2, damage 0.5: 99.9 % have broken at sqrt(ln 1000) / 0.5; half-way, 1 - 1000^(-1/4) have.
  const LifeCurve curve = life_curve(0.5, 2, 3);
  ASSERT_EQ(curve.repeats.size(), 3U);
  EXPECT_EQ(curve.repeats[0], 0);
  EXPECT_EQ(curve.broken[0], 0);
  EXPECT_NEAR(curve.repeats[1], 2.628260884, 1e-9);
  EXPECT_NEAR(curve.broken[1], 0.822172059, 1e-9);
  EXPECT_NEAR(curve.repeats[2], 5.256521769, 1e-9);
  EXPECT_NEAR(curve.broken[2], 0.999, 1e-12);
}

TEST(LifeCurve, IsEmptyWhereThereIsNoEnd) {
  EXPECT_TRUE(life_curve(0, 5.94).repeats.empty());
  EXPECT_TRUE(life_curve(std::numeric_limits<double>::quiet_NaN(), 5.94).repeats.empty());
  EXPECT_TRUE(life_curve(std::numeric_limits<double>::infinity(), 5.94).repeats.empty());
  EXPECT_TRUE(life_curve(1e-310, 0.5).repeats.empty());
  EXPECT_TRUE(life_curve(0.5, 0).repeats.empty());
}

}  // namespace
}  // namespace host_sim
