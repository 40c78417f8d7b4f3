#include "host_sim/recording/signal.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/recording/support.hpp"

namespace host_sim::recording {
namespace {

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

}  // namespace
}  // namespace host_sim::recording
