#include "host_sim/recording/sensor.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "host_sim/recording/signal.hpp"
#include "host_sim/statistics/random.hpp"

namespace host_sim::recording {

namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Ten cycles of a sine of amplitude 100, with noise and rounded to whole steps of `step`.
std::vector<double> sine(double noise, double step) {
  statistics::Random random(7, 0, 0);
  std::vector<double> values;
  for (int i = 0; i < 4000; ++i) {
    double normal = -6;
    for (int k = 0; k < 12; ++k) {
      normal += random.uniform();
    }
    const double value = 100 * std::sin(2 * std::numbers::pi * i / 400) + noise * normal;
    values.push_back(step > 0 ? step * std::round(value / step) : value);
  }
  return values;
}

TEST(Sensor, WithFineNoiseRepeatsEightValuesNeverByChance) {
  EXPECT_EQ(sensor_of(sine(1, 0)).longest_by_chance, 8U);
  EXPECT_EQ(sensor_of(sine(1, 0.1)).longest_by_chance, 8U);
}

TEST(Sensor, WithCoarseNoiseMayRepeatMore) {
  EXPECT_EQ(sensor_of(sine(1, 1)).longest_by_chance, 50U);
}

TEST(Sensor, WithoutMuchNoiseTellsNothing) {
  EXPECT_EQ(sensor_of(sine(0, 0)).longest_by_chance, 0U);
  EXPECT_EQ(sensor_of(sine(0, 0.1)).longest_by_chance, 0U);
  EXPECT_EQ(sensor_of(sine(0, 5)).longest_by_chance, 0U);
  EXPECT_EQ(sensor_of(sine(0.2, 1)).longest_by_chance, 0U);
}

TEST(Sensor, IsJudgedOutsideOfLongRowsOfEqualValues) {
  std::vector<double> values = sine(1, 0.1);
  std::fill(values.begin() + 500, values.begin() + 3000, 20);
  EXPECT_EQ(sensor_of(values).longest_by_chance, 8U);
  std::fill(values.begin() + 100, values.end(), 20);
  EXPECT_EQ(sensor_of(values).longest_by_chance, 0U);  // too few are left
}

TEST(Sensor, KnowsItsRangeAndItsNoise) {
  const Sensor sensor = sensor_of(std::vector<double>{3, 1, 2});
  EXPECT_EQ(sensor.lowest, 1);
  EXPECT_EQ(sensor.highest, 3);
  EXPECT_EQ(sensor.span(), 2);
  EXPECT_NEAR(sensor_of(sine(1, 0)).noise_sigma, 1, 0.05);
}

TEST(NoiseSigma, IsZeroOnALineAndForFewValues) {
  EXPECT_EQ(noise_sigma(std::vector<double>{1, 2, 3, 4, 5}), 0);
  EXPECT_EQ(noise_sigma(std::vector<double>{1, 9}), 0);
  // One bend of 3: over 0.67449 times the square root of 6.
  EXPECT_NEAR(noise_sigma(std::vector<double>{0, 0, 3}), 1.8158095, 1e-6);
}

TEST(Quantile, IsAValueOfTheSample) {
  EXPECT_EQ(quantile({5, 1, 4, 2, 3}, 0), 1);
  EXPECT_EQ(quantile({5, 1, 4, 2, 3}, 0.5), 3);
  EXPECT_EQ(quantile({5, 1, 4, 2, 3}, 1), 5);
  EXPECT_EQ(quantile({7}, 0.3), 7);
}

TEST(StillStretches, AreRowsOfEqualValues) {
  const std::vector<double> values{1, 1, 2, 2, 2, 3, 4, 4};
  EXPECT_THAT(still_stretches(values, 2), ElementsAre(Stretch{0, 2}, Stretch{2, 3}, Stretch{6, 2}));
  EXPECT_THAT(still_stretches(values, 3), ElementsAre(Stretch{2, 3}));
  EXPECT_THAT(still_stretches({}, 1), IsEmpty());
}

/// A wave of 40 values.
std::vector<double> held(std::size_t samples) {
  std::vector<double> values;
  for (std::size_t i = 0; i < 40; ++i) {
    values.insert(values.end(), samples, std::sin(0.7 * static_cast<double>(i)));
  }
  return values;
}

TEST(Hold, IsForHowManySamplesEachValueStays) {
  EXPECT_EQ(hold_of(held(1)), 1);
  EXPECT_EQ(hold_of(held(2)), 2);
  EXPECT_EQ(hold_of(held(10)), 10);
}

/// Of 2 .. 9 samples, and of steps of 0.1 that a ramp takes every 7 samples.
TEST(Hold, IsNoRestAndNoCoarseScale) {
  std::vector<double> irregular;
  std::vector<double> ramp;
  for (std::size_t i = 0; i < 60; ++i) {
    irregular.insert(irregular.end(), 2 + 3 * i % 8, std::sin(0.7 * static_cast<double>(i)));
    ramp.insert(ramp.end(), 7, 0.1 * static_cast<double>(i));
  }
  EXPECT_EQ(hold_of(irregular), 1);
  EXPECT_EQ(hold_of(ramp), 1);
  EXPECT_EQ(hold_of(std::vector<double>(500, 3.0)), 1);
  EXPECT_EQ(hold_of({}), 1);
}

TEST(StretchesOf, AreRowsOfTheWantedMark) {
  const std::vector<bool> marks{true, true, false, true, false, false};
  EXPECT_THAT(stretches_of(marks, true), ElementsAre(Stretch{0, 2}, Stretch{3, 1}));
  EXPECT_THAT(stretches_of(marks, true, 2), ElementsAre(Stretch{0, 2}));
  EXPECT_THAT(stretches_of(marks, false), ElementsAre(Stretch{2, 1}, Stretch{4, 2}));
  EXPECT_THAT(stretches_of({}, true), IsEmpty());
}

TEST(Excursions, AreMeasuredWithinTheStretch) {
  const std::vector<double> values{99, 4, 1, 6, 3, -99};
  const Stretch inner{1, 4};
  EXPECT_EQ(rise_in(values, inner), 5);   // 1 to 6
  EXPECT_EQ(fall_in(values, inner), 3);   // 4 to 1, 6 to 3
  EXPECT_EQ(swing_in(values, inner), 3);  // 4, 1 and up again; 1, 6 and 3 of it back
}

TEST(Excursions, OfAOneWayMotionDoNotSwing) {
  const std::vector<double> values{1, 2, 2, 5, 9};
  EXPECT_EQ(rise_in(values, {0, 5}), 8);
  EXPECT_EQ(fall_in(values, {0, 5}), 0);
  EXPECT_EQ(swing_in(values, {0, 5}), 0);
  EXPECT_EQ(swing_in(values, {2, 1}), 0);
}

}  // namespace
}  // namespace host_sim::recording
