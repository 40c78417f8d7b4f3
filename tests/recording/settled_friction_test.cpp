#include "host_sim/recording/settled_friction.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace host_sim::recording {
namespace {

/// Two strokes of 20 samples at 2 rad, of which the first `unsettled` each are just behind the turn
/// and have no friction at all.
Covariates strokes(double mu, std::size_t unsettled) {
  Covariates made;
  for (const double direction : {1.0, -1.0}) {
    for (std::size_t i = 0; i < 20; ++i) {
      const bool settled = i >= unsettled;
      made.time_s.push_back(static_cast<double>(made.samples()) * 0.01);
      made.direction.push_back(direction);
      made.bend_angle_rad.push_back(2);
      made.travel_m.push_back(settled ? 0.01 : 0.001);
      made.input_tension_N.push_back(40);
      made.output_tension_N.push_back(40 * std::exp(0.3 - (settled ? mu * 2 * direction : 0.0)));
    }
  }
  return made;
}

TEST(SettledFriction, IsThatOfTheSamplesFarFromReversals) {
  EXPECT_NEAR(settled_friction(strokes(0.12, 0)), 0.12, 1e-12);
  EXPECT_NEAR(settled_friction(strokes(0.12, 14)), 0.12, 1e-12);
}

TEST(SettledFriction, IsNotToldByTheEndsOfShortStrokes) {
  EXPECT_EQ(settled_friction(strokes(0.12, 16)), 0);
}

TEST(SettledFriction, IsNotToldByOneDirection) {
  Covariates one = strokes(0.12, 0);
  for (double& direction : one.direction) {
    direction = 1;
  }
  EXPECT_EQ(settled_friction(one), 0);
}

}  // namespace
}  // namespace host_sim::recording
