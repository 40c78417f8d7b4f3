#include <gtest/gtest.h>

#include "host_sim/statistics/goodness_of_fit.hpp"
#include "tests/statistics/samples.hpp"

namespace host_sim::statistics {
namespace {

TEST(PlottingPositions, MedianRanksOfFailures) {
  const auto positions = plotting_positions(failed({30, 10, 20}));
  ASSERT_EQ(positions.size(), 3U);
  EXPECT_EQ(positions[0].life, 10);
  EXPECT_DOUBLE_EQ(positions[0].p, 0.7 / 3.4);
  EXPECT_DOUBLE_EQ(positions[1].p, 0.5);
  EXPECT_EQ(positions[2].life, 30);
  EXPECT_DOUBLE_EQ(positions[2].p, 2.7 / 3.4);
}

// Five specimens, the second suspended: the ranks are 1, then each (6 - 1) / (1 + 3) = 5/4 higher.
TEST(PlottingPositions, RanksAreAdjustedForTheSuspended) {
  const auto positions = plotting_positions(with_suspended({1, 3, 4, 5}, {2}));
  ASSERT_EQ(positions.size(), 4U);
  EXPECT_DOUBLE_EQ(positions[0].p, (1 - 0.3) / 5.4);
  EXPECT_DOUBLE_EQ(positions[1].p, (2.25 - 0.3) / 5.4);
  EXPECT_DOUBLE_EQ(positions[2].p, (3.5 - 0.3) / 5.4);
  EXPECT_DOUBLE_EQ(positions[3].p, (4.75 - 0.3) / 5.4);
}

TEST(PlottingPositions, ASpecimenSuspendedAtALifeOutlivedTheFailureThere) {
  const auto positions = plotting_positions(with_suspended({2, 3}, {2}));
  EXPECT_DOUBLE_EQ(positions[0].p, 0.7 / 3.4);
  EXPECT_DOUBLE_EQ(positions[1].p, (2.5 - 0.3) / 3.4);
}

TEST(PlottingPositions, NoneWithoutFailures) {
  EXPECT_TRUE(plotting_positions(with_suspended({}, {2, 3})).empty());
}

}  // namespace
}  // namespace host_sim::statistics
