#include "host_sim/recording/smooth.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/recording/times.hpp"

namespace host_sim::recording {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;

TEST(Smoothed, KeepsACubicAndNotASpike) {
  const std::vector<double> time_s = times(31, 0.01);
  std::vector<double> values;
  for (const double t : time_s) {
    values.push_back(1 - 2 * t + 30 * t * t - 100 * t * t * t);
  }
  const std::vector<Stretch> whole{{0, 31}};
  const std::vector<double> same = smoothed(time_s, values, whole, 0.05);
  for (std::size_t i = 6; i < 25; ++i) {
    EXPECT_NEAR(same[i], values[i], 1e-12) << i;
  }
  std::vector<double> spiked = values;
  spiked[15] += 1;
  // The middle weight of a cubic over 11 samples is 89/429 (Savitzky and Golay, table of n = 11).
  EXPECT_NEAR(smoothed(time_s, spiked, whole, 0.05)[15] - values[15], 89.0 / 429, 1e-12);
}

TEST(Smoothed, LeavesWhatIsTooShortToFit) {
  const std::vector<double> time_s = times(9, 1);
  const std::vector<double> values{1, 5, 2, 8, 3, 9, 1, 7, 4};
  EXPECT_EQ(smoothed(time_s, values, std::vector<Stretch>{{0, 9}}, 0.05), values);
}

TEST(MovingMean, IsOverAsManySamplesOnBothSidesAsThePieceHas) {
  const std::vector<double> time_s = times(7, 1);
  const std::vector<double> values{0, 3, 6, 0, 3, 6, 100};
  EXPECT_THAT(moving_mean(time_s, values, std::vector<Stretch>{{0, 6}}, 2),
              ElementsAre(0, 3, DoubleNear(2.4, 1e-12), DoubleNear(3.6, 1e-12), 3, 6, 100));
}

TEST(MovingMean, KeepsWhatIsLinear) {
  const std::vector<double> time_s = times(200, 0.01);
  std::vector<double> values;
  for (const double t : time_s) {
    values.push_back(20 + 3 * t);
  }
  const std::vector<double> means =
      moving_mean(time_s, values, std::vector<Stretch>{{0, 80}, {80, 120}}, 0.1);
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_NEAR(means[i], values[i], 1e-12) << i;
  }
}

}  // namespace
}  // namespace host_sim::recording
