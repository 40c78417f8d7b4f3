#include "host_sim/recording/signal.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "tests/recording/support.hpp"

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

using testing::Each;

TEST(LogRate, OfAnExponentialIsItsExponent) {
  const std::vector<double> time_s = times(9, 0.01);
  std::vector<double> tension_N;
  for (const double t : time_s) {
    tension_N.push_back(20 * std::exp(3 * t));
  }
  const std::vector<Stretch> whole{{0, 9}};
  EXPECT_THAT(log_rate_1_s(time_s, tension_N, whole), Each(DoubleNear(3, 1e-9)));
  EXPECT_THAT(smooth_log_rate_1_s(time_s, tension_N, whole), Each(DoubleNear(3, 1e-9)));
}

// ln T = t - 40 t^3: the slope is 1 - 120 t^2. At the ends a quadratic is fitted, which a cubic is
// not.
TEST(LogRate, ThatIsSmoothedIsExactForACubicAwayFromTheEnds) {
  const std::vector<double> time_s = times(41, 0.005);
  std::vector<double> tension_N;
  for (const double t : time_s) {
    tension_N.push_back(std::exp(t - 40 * t * t * t));
  }
  const std::vector<double> rate_1_s =
      smooth_log_rate_1_s(time_s, tension_N, std::vector<Stretch>{{0, 41}});
  for (std::size_t i = 11; i < 30; ++i) {
    EXPECT_NEAR(rate_1_s[i], 1 - 120 * time_s[i] * time_s[i], 1e-6) << i;
  }
  EXPECT_GT(std::abs(rate_1_s[0] - 1), 1e-3);
}

// The slope of a cubic over 2 m + 1 samples at steps h has the variance S6 / (h^2 (S2 S6 - S4^2))
// for white noise of variance 1, Sk the sum of the k-th powers of -m..m. With m = 10: S2 = 770, S4
// = 50,666, S6 = 3,956,810, and at 5 ms 329.94 1/s^2. Differences over four steps have 5000.
TEST(LogRate, ThatIsSmoothedHasTheNoiseOfItsWeights) {
  const std::vector<double> time_s = times(41, 0.005);
  double square = 0;
  for (std::size_t at = 10; at <= 30; ++at) {
    std::vector<double> tension_N(41, 1.0);
    tension_N[at] = std::exp(1.0);
    const double weight = smooth_log_rate_1_s(time_s, tension_N, std::vector<Stretch>{{0, 41}})[20];
    square += weight * weight;
  }
  EXPECT_NEAR(square, 329.94, 0.01);
}

TEST(LogRate, OfFewSamplesIsByDifferences) {
  const std::vector<double> time_s = times(5, 1);
  const std::vector<double> tension_N{1, 2, 4, 32, 64};
  const std::vector<Stretch> whole{{0, 5}};
  const std::vector<double> expected = log_rate_1_s(time_s, tension_N, whole);
  EXPECT_EQ(smooth_log_rate_1_s(time_s, tension_N, whole), expected);
  EXPECT_NEAR(expected[2], std::log(64.0) / 4, 1e-12);
}

TEST(LogRate, OutsideOfThePiecesIsZeroAndEachStandsForItself) {
  const std::vector<double> time_s = times(6, 1);
  const double e = std::numbers::e;
  const std::vector<double> tension_N{1, e, 5, 1, 1 / e, 1 / (e * e)};
  const std::vector<Stretch> pieces{{0, 2}, {3, 3}};
  EXPECT_THAT(log_rate_1_s(time_s, tension_N, pieces),
              ElementsAre(DoubleNear(1, 1e-12), DoubleNear(1, 1e-12), 0, DoubleNear(-1, 1e-12),
                          DoubleNear(-1, 1e-12), DoubleNear(-1, 1e-12)));
}

}  // namespace

}  // namespace host_sim::recording
