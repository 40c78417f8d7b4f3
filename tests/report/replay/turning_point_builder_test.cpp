#include "host_sim/report/replay/turning_point_builder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace host_sim {
namespace {

std::vector<double> tensions_of(const TurningPoints& turning_points) {
  std::vector<double> tensions;
  for (const TurningPoint& point : turning_points.points) {
    tensions.push_back(point.tension_N);
  }
  return tensions;
}

TurningPoints of_values(std::size_t max_points, const std::vector<double>& values) {
  TurningPointBuilder builder(max_points);
  for (std::size_t i = 0; i < values.size(); ++i) {
    builder.push(static_cast<double>(i), values[i]);
  }
  return builder.finish();
}

TEST(TurningPointBuilder, KeepsAllInOrderWhileTheyFit) {
  const std::vector<double> values = {3, 1, 4, 1, 5, 1, 9, 2};
  for (std::size_t count = 0; count <= values.size(); ++count) {
    const std::vector<double> first(values.begin(),
                                    values.begin() + static_cast<std::ptrdiff_t>(count));
    const TurningPoints kept = of_values(8, first);
    EXPECT_EQ(tensions_of(kept), first);
    EXPECT_EQ(kept.total, count);
  }
}

TEST(TurningPointBuilder, ThinnedRunsKeepTheirLowestAndHighest) {
  const TurningPoints kept = of_values(4, {5, 2, 7, 3, 8, 1, 6, 4});
  EXPECT_EQ(tensions_of(kept), (std::vector<double>{2, 7, 8, 1}));
  EXPECT_EQ(kept.total, 8U);
}

TEST(TurningPointBuilder, EqualPointsInARunDoNotDouble) {
  const TurningPoints kept = of_values(4, {5, 5, 5, 5, 5});
  for (std::size_t i = 1; i < kept.points.size(); ++i) {
    EXPECT_LT(kept.points[i - 1].time_s, kept.points[i].time_s);
  }
}

TEST(TurningPointBuilder, IsABoundedSubsetWithTheExtremes) {
  std::mt19937 random(7);
  std::vector<double> values;
  for (int i = 0; i < 54'321; ++i) {
    values.push_back(static_cast<double>(random()));
  }
  const TurningPoints kept = of_values(200, values);
  ASSERT_LE(kept.points.size(), 200U);
  ASSERT_GE(kept.points.size(), 100U);
  EXPECT_EQ(kept.total, values.size());
  for (const TurningPoint& point : kept.points) {
    EXPECT_EQ(values[static_cast<std::size_t>(point.time_s)], point.tension_N);
  }
  EXPECT_TRUE(std::is_sorted(kept.points.begin(), kept.points.end(),
                             [](const auto& a, const auto& b) { return a.time_s < b.time_s; }));
  const std::vector<double> tensions = tensions_of(kept);
  EXPECT_EQ(*std::min_element(tensions.begin(), tensions.end()),
            *std::min_element(values.begin(), values.end()));
  EXPECT_EQ(*std::max_element(tensions.begin(), tensions.end()),
            *std::max_element(values.begin(), values.end()));
}

}  // namespace
}  // namespace host_sim
