#include "host_sim/recording/motion.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "host_sim/recording/sensor.hpp"
#include "host_sim/statistics/random.hpp"
#include "tests/recording/support.hpp"

namespace host_sim::recording {
namespace {

using testing::ElementsAre;

Motion motion_in(const std::vector<double>& velocity_m_s, double dead_band_m_s,
                 const std::vector<Stretch>& stretches = {}) {
  const std::vector<Stretch> whole{{0, velocity_m_s.size()}};
  return motion_of(times(velocity_m_s.size()), velocity_m_s, stretches.empty() ? whole : stretches,
                   dead_band_m_s);
}

TEST(Motion, KeepsTheLastDirectionAtZeroAndPullsAtTheStart) {
  const Motion motion = motion_in({0, 1, 0, -1, 0, 0, -1, 1}, 0);
  EXPECT_THAT(motion.direction, ElementsAre(1, 1, 1, -1, -1, -1, -1, 1));
  EXPECT_THAT(motion.reversals, ElementsAre(0, 0, 0, 1, 1, 1, 1, 2));
}

TEST(Motion, ThatBeginsByLettingGoIsNoReversal) {
  const Motion motion = motion_in({0, -1, -1, 1}, 0);
  EXPECT_THAT(motion.direction, ElementsAre(1, -1, -1, 1));
  EXPECT_THAT(motion.reversals, ElementsAre(0, 0, 0, 1));
}

// From 2 to -2 the velocity is zero in the middle of a step: half a step at half of 2.
TEST(Motion, TravelsByTrapezoidsFromWhereTheVelocityIsZero) {
  const Motion motion = motion_in({2, 4, 2, -2, -6, 0, 0, 2, 4}, 0);
  EXPECT_THAT(motion.travel_m, ElementsAre(0, 3, 6, 0.5, 4.5, 7.5, 7.5, 1, 4));
}

TEST(Motion, IsKnownAfterAReversalOrFiveMillimetres) {
  const double v = 0.002;  // in a second 2 mm
  EXPECT_THAT(motion_in({0, v, v, v, v, v, -v, -v}, 0).known,
              ElementsAre(false, false, false, false, true, false, false, true));
  EXPECT_THAT(motion_in({v, v, -v, -v, 0, 0}, 0).known,
              ElementsAre(false, false, false, true, true, true));
  EXPECT_THAT(motion_in({0, 0, 0}, 0).known, ElementsAre(false, false, false));
}

TEST(Motion, TurnsWhereTheSignChangedBeforeTheDeadBandIsLeft) {
  const Motion motion = motion_in({5, 1, -1, -2, -5, -1, 1, 0, 1, 5}, 3);
  EXPECT_THAT(motion.direction, ElementsAre(1, 1, -1, -1, -1, -1, -1, -1, 1, 1));
}

TEST(Motion, DoesNotTurnWithinTheDeadBand) {
  const Motion motion = motion_in({5, 3, -3, 3, -3, 3, 5, 2, -2, 2}, 3);
  EXPECT_THAT(motion.direction, testing::Each(1.0));
  EXPECT_THAT(motion.reversals, testing::Each(0.0));
}

TEST(Motion, IsNotKnownWithinTheDeadBandAroundAReversal) {
  const Motion motion = motion_in({5, 1, -1, -2, -5, -1, -5, 1, 0, 5, 5}, 3);
  EXPECT_THAT(motion.known,
              ElementsAre(false, false, false, false, true, true, true, false, false, false, true));
}

TEST(Motion, IsNotKnownWhereTheEndCutsATurnOff) {
  EXPECT_THAT(motion_in({5, -5, -2, 0, -1, 1, -1}, 3).known,
              ElementsAre(false, false, true, true, false, false, false));
  EXPECT_THAT(motion_in({5, -5, -2, 0, 0}, 3).known, ElementsAre(false, false, true, true, true));
}

TEST(Motion, IsNotKnownNextToAReversal) {
  EXPECT_THAT(motion_in({1, 1, 1, 1, -1, -1, -1, 1, 1}, 0).known,
              ElementsAre(false, true, true, false, false, true, false, false, true));
}

TEST(Motion, SlipsFromFiveMillimetresBehindAReversalToTheNext) {
  const double v = 0.002;
  const Motion motion = motion_in({v, v, v, v, v, -v, -v, -v, -v, -v, 0, v}, v / 2);
  EXPECT_THAT(slips_of(motion), ElementsAre(Stretch{3, 1}, Stretch{8, 2}));
}

TEST(Motion, BeginsAnewBehindAGap) {
  const Motion motion =
      motion_in({1, 1, 1, -1, -1, 1, 1, -1, -1, -1, 1}, 0, {{0, 5}, {5, 5}, {10, 1}});
  // The tendon turned in the gap before sample 5, and in the one before sample 10.
  EXPECT_THAT(motion.reversals, ElementsAre(0, 0, 0, 1, 1, 2, 2, 3, 3, 3, 4));
  EXPECT_THAT(motion.travel_m, ElementsAre(0, 1, 2, 0.25, 1.25, 0, 1, 0.25, 1.25, 2.25, 0));
  EXPECT_THAT(motion.known,
              ElementsAre(false, true, false, false, true, false, false, false, true, true, false));
}

TEST(Motion, OutsideOfTheStretchesIsNotKnownAndTheCountStands) {
  const Motion motion = motion_in({1, -1, 1, 9, 9, 1, -1}, 0, {{0, 3}, {5, 2}});
  EXPECT_THAT(motion.reversals, ElementsAre(0, 1, 2, 2, 2, 2, 3));
  EXPECT_FALSE(motion.known[3]);
  EXPECT_FALSE(motion.known[4]);
}

TEST(DeadBand, IsHalfAPercentOfTheTopSpeedForACleanSine) {
  std::vector<double> velocity_m_s;
  for (int i = 0; i < 4000; ++i) {
    velocity_m_s.push_back(0.2 * std::sin(2 * 3.141592653589793 * i / 400));
  }
  // The 99 % quantile of |sin| is sin(0.99 * 90 deg) = 0.999877.
  EXPECT_NEAR(dead_band_m_s(velocity_m_s), 0.005 * 0.2 * 0.99988, 1e-6);
}

TEST(DeadBand, IsFourTimesTheNoise) {
  std::vector<double> velocity_m_s;
  statistics::Random random(1, 2, 3);
  for (int i = 0; i < 4000; ++i) {
    double normal = -6;
    for (int k = 0; k < 12; ++k) {
      normal += random.uniform();
    }
    velocity_m_s.push_back(0.2 * std::sin(2 * 3.141592653589793 * i / 400) + 0.004 * normal);
  }
  EXPECT_NEAR(noise_sigma(velocity_m_s), 0.004, 0.0003);
  EXPECT_NEAR(dead_band_m_s(velocity_m_s), 0.016, 0.0012);
  // Noise makes no reversals: ten cycles have twenty, the one at the start aside.
  const std::vector<Stretch> whole{{0, 4000}};
  const Motion motion =
      motion_of(times(4000, 0.005), velocity_m_s, whole, dead_band_m_s(velocity_m_s));
  EXPECT_EQ(motion.reversals.back(), 19);
}

TEST(DeadBand, IsTheResolutionOfACoarseSensor) {
  std::vector<double> velocity_m_s;
  for (int i = 0; i < 4000; ++i) {
    velocity_m_s.push_back(0.01 * std::round(30 * std::sin(2 * 3.141592653589793 * i / 4000)));
  }
  EXPECT_NEAR(dead_band_m_s(velocity_m_s), 0.01, 1e-12);
}

TEST(DeadBand, IsZeroForATendonAtRest) {
  EXPECT_EQ(dead_band_m_s(std::vector<double>(20)), 0);
  EXPECT_EQ(dead_band_m_s({}), 0);
}

RC_GTEST_PROP(Motion, ScalesWithTheVelocity, (const std::vector<int>& steps)) {
  const std::vector<double> velocity(steps.begin(), steps.end());
  std::vector<double> doubled = velocity;
  for (double& v : doubled) {
    v *= 2;
  }
  RC_ASSERT(dead_band_m_s(doubled) == 2 * dead_band_m_s(velocity));
  const Motion one = motion_in(velocity, dead_band_m_s(velocity));
  const Motion two = motion_in(doubled, dead_band_m_s(doubled));
  RC_ASSERT(one.direction == two.direction);
  RC_ASSERT(one.reversals == two.reversals);
  for (std::size_t i = 0; i < velocity.size(); ++i) {
    RC_ASSERT(two.travel_m[i] == 2 * one.travel_m[i]);
  }
}

RC_GTEST_PROP(Motion, MirrorsWithTheVelocityOnceItMoves, (const std::vector<int>& steps)) {
  const std::vector<double> velocity(steps.begin(), steps.end());
  std::vector<double> mirrored = velocity;
  for (double& v : mirrored) {
    v = -v;
  }
  const Motion one = motion_in(velocity, 2);
  const Motion two = motion_in(mirrored, 2);
  RC_ASSERT(one.travel_m == two.travel_m);
  RC_ASSERT(one.reversals == two.reversals);
  for (std::size_t i = 0; i < velocity.size(); ++i) {
    RC_ASSERT(one.known[i] == two.known[i]);
    RC_ASSERT(!one.known[i] || one.direction[i] == -two.direction[i]);
  }
}

RC_GTEST_PROP(Motion, OfCleanVelocityFollowsItsSign, (const std::vector<std::int8_t>& steps)) {
  const std::vector<double> velocity(steps.begin(), steps.end());
  const Motion motion = motion_in(velocity, 0);
  double direction = 1;
  for (std::size_t i = 0; i < velocity.size(); ++i) {
    direction = velocity[i] == 0 ? direction : std::copysign(1, velocity[i]);
    RC_ASSERT(motion.direction[i] == direction);
    RC_ASSERT(motion.travel_m[i] >= 0);
  }
}

}  // namespace
}  // namespace host_sim::recording
