#include "host_sim/report/replay/trajectory_builder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace host_sim {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Trajectory of_first_numbers(std::size_t max_points, int count) {
  TrajectoryBuilder builder(max_points);
  for (int i = 0; i < count; ++i) {
    builder.push(i, 10.0 * i);
  }
  return builder.finish();
}

TEST(TrajectoryBuilder, KeepsAllWhileTheyFit) {
  EXPECT_THAT(of_first_numbers(4, 0).time_s, IsEmpty());
  EXPECT_THAT(of_first_numbers(4, 1).time_s, ElementsAre(0));
  EXPECT_THAT(of_first_numbers(4, 4).time_s, ElementsAre(0, 1, 2, 3));
}

TEST(TrajectoryBuilder, ThinsByDoublingAndKeepsTheLast) {
  EXPECT_THAT(of_first_numbers(4, 5).time_s, ElementsAre(0, 2, 4));
  EXPECT_THAT(of_first_numbers(4, 6).time_s, ElementsAre(0, 2, 4, 5));
  EXPECT_THAT(of_first_numbers(4, 10).time_s, ElementsAre(0, 4, 8, 9));
  EXPECT_THAT(of_first_numbers(4, 10).damage, ElementsAre(0, 40, 80, 90));
}

TEST(TrajectoryBuilder, IsBoundedWithFirstAndLastForAnyLength) {
  for (const int count : {1, 2, 99, 100, 101, 1023, 1024, 1025, 100'003}) {
    const Trajectory trajectory = of_first_numbers(100, count);
    EXPECT_LE(trajectory.time_s.size(), 101U);
    EXPECT_GE(trajectory.time_s.size(), static_cast<std::size_t>(std::min(count, 50)));
    EXPECT_EQ(trajectory.time_s.front(), 0);
    EXPECT_EQ(trajectory.time_s.back(), count - 1);
  }
}

}  // namespace
}  // namespace host_sim
