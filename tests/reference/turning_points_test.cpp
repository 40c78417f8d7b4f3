#include "host_sim/reference/turning_points.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstddef>
#include <optional>

#include "tests/reference/signals.hpp"

namespace host_sim::reference::testing {
namespace {

TEST(TurningPoints, WithoutHysteresisTheFirstSampleIsTheFirstTurningPoint) {
  EXPECT_EQ(turning_points({3, 3, 5, 4, 4, 7}), (Signal{3, 5, 4, 7}));
}

TEST(TurningPoints, AConstantSignalHasNone) {
  EXPECT_TRUE(turning_points({7, 7, 7}).empty());
}

TEST(TurningPoints, NoneWhileTheSignalStaysWithinTheHysteresis) {
  EXPECT_TRUE(turning_points({10, 10.9, 9.95, 10.5}, 1.0).empty());
}

TEST(TurningPoints, TheEarlierExtremumIsFirstEvenIfItIsNotTheFirstSample) {
  EXPECT_EQ(turning_points({10, 9.6, 10.3, 10.6, 11}, 1.0), (Signal{9.6, 11}));
  EXPECT_EQ(turning_points({10, 10.4, 9.7, 9.4, 9}, 1.0), (Signal{10.4, 9}));
}

TEST(TurningPoints, ConfirmedWhenTheSignalHasComeBackByTheHysteresis) {
  TurningPointFilter filter(2.0);
  EXPECT_EQ(filter.push(0), std::nullopt);
  EXPECT_EQ(filter.unconfirmed(), std::nullopt);
  EXPECT_EQ(filter.push(5), 0.0);
  EXPECT_EQ(filter.unconfirmed(), 5.0);
  EXPECT_EQ(filter.push(3.5), std::nullopt);
  EXPECT_EQ(filter.push(6), std::nullopt);
  EXPECT_EQ(filter.unconfirmed(), 6.0);
  EXPECT_EQ(filter.push(4), 6.0);
  EXPECT_EQ(filter.unconfirmed(), 4.0);
}

TEST(TurningPoints, ASwingOfTheHysteresisInDecimalsCounts) {
  EXPECT_LT(8.7 - 8.5, 0.2);
  EXPECT_EQ(turning_points({8.0, 8.7, 8.5, 9.0}, 0.2), (Signal{8.0, 8.7, 8.5, 9.0}));
}

RC_GTEST_PROP(TurningPoints, AlternateAndLieAtLeastTheHysteresisApart, ()) {
  const Signal signal = *any_signal();
  const double hysteresis_N = *rc::gen::element(0.0, 0.2, 1.0, 5.0);
  const Signal points = turning_points(signal, hysteresis_N);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double swing_N = points[i] - points[i - 1];
    RC_ASSERT(swing_N != 0.0);
    RC_ASSERT(std::abs(swing_N) >= hysteresis_N * (1 - 1e-9));
    if (i >= 2) {
      RC_ASSERT((swing_N > 0) != (points[i - 1] - points[i - 2] > 0));
    }
  }
}

RC_GTEST_PROP(TurningPoints, KeepTheHighestAndLowestSample, ()) {
  const Signal signal = *rc::gen::nonEmpty(any_signal());
  const double hysteresis_N = *rc::gen::element(0.0, 0.2, 1.0);
  const auto [lowest, highest] = std::minmax_element(signal.begin(), signal.end());
  RC_PRE(*highest - *lowest >= hysteresis_N && *highest > *lowest);
  const Signal points = turning_points(signal, hysteresis_N);
  RC_ASSERT(*std::max_element(points.begin(), points.end()) == *highest);
  RC_ASSERT(*std::min_element(points.begin(), points.end()) == *lowest);
}

}  // namespace
}  // namespace host_sim::reference::testing
