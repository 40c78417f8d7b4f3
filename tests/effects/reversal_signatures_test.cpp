#include <gtest/gtest.h>

#include <cmath>

#include "tests/effects/trace.hpp"

namespace host_sim::effects::testing {
namespace {

/// r of a sample.
double residual(double output_N, double input_N, double angle_and_direction) {
  return std::log(output_N) - std::log(input_N) + kMu * angle_and_direction;
}

/// Steps of 0.1 mm; reversals at samples 3 and 7.
recording::Covariates strokes() {
  recording::Covariates c;
  c.direction = {1, 1, 1, -1, -1, -1, -1, 1, 1, 1};
  c.travel_m = {0, 1e-4, 2e-4, 1e-4, 2e-4, 3e-4, 4e-4, 1e-4, 2e-4, 3e-4};
  for (std::size_t i = 0; i < c.direction.size(); ++i) {
    c.time_s.push_back(0.01 * static_cast<double>(i));
    c.bend_angle_rad.push_back(2);
    c.velocity_m_s.push_back(0.01 * c.direction[i]);
    c.input_tension_N.push_back(50 - 2 * static_cast<double>(i));
    c.output_tension_N.push_back(c.input_tension_N[i] * std::exp(-kMu * 2 * c.direction[i]));
  }
  return c;
}

/// Dahl's equation dz/dx = (1 - z s)/d over 0.1 mm, in a thousand steps of Euler's.
double dahl(double z, double direction, double length_m) {
  constexpr int kSteps = 1000;
  for (int k = 0; k < kSteps; ++k) {
    z += direction * (1 - z * direction) / length_m * 1e-4 / kSteps;
  }
  return z;
}

TEST(Presliding, FollowsDahlsEquation) {
  const recording::Covariates c = strokes();
  const auto found = columns("presliding", c, {3.5e-4});
  double z = 1;
  std::vector<double> expected;
  for (std::size_t i = 0; i < c.samples(); ++i) {
    z = dahl(z, c.direction[i], 3.5e-4);
    const double output_N = c.input_tension_N[i] * std::exp(-kMu * 2 * z);
    expected.push_back(residual(output_N, c.input_tension_N[i], 2 * c.direction[i]));
  }
  expect_same(found[0], expected, 1e-3);
}

TEST(Presliding, IsTwiceTheFrictionAtAReversalAndFadesWithTravel) {
  const auto found = columns("presliding", strokes(), {1e-4});
  EXPECT_EQ(found[0][2], 0);  // nothing before the first reversal
  EXPECT_NEAR(found[0][3], -2 * 0.128 * 2 * std::exp(-1.0), 1e-12);
  EXPECT_NEAR(found[0][6], -2 * 0.128 * 2 * std::exp(-4.0), 1e-12);
  // at the second reversal a share exp(-4) of the swing had not been reached
  EXPECT_NEAR(found[0][7], 0.128 * 2 * (2 - 2 * std::exp(-4.0)) * std::exp(-1.0), 1e-12);
}

TEST(Slack, StandsWhereNothingMovesAfterAReversal) {
  const auto found = columns("slack", strokes(), {2e-4});
  EXPECT_EQ(found[0], (std::vector<double>{0, 0, 0, 1, 0, 0, 0, 1, 0, 0}));
  EXPECT_NEAR(found[1][3], -0.128 * 2, 1e-15);
  EXPECT_NEAR(found[1][7], 0.128 * 2, 1e-15);
}

TEST(Slack, HoldsBothTensionsOrLetsTheDriveRunLoose) {
  const recording::Covariates c = strokes();
  const auto found = columns("slack", c, {4e-4});
  for (const std::size_t i : {3U, 4U, 5U, 7U, 8U, 9U}) {
    const std::size_t before = i < 7 ? 2 : 6;
    const double frozen =
        residual(c.output_tension_N[before], c.input_tension_N[before], 2 * c.direction[i]);
    EXPECT_NEAR(0 * found[0][i] + 2 * found[1][i], frozen, 1e-12) << i;
    const double loose = residual(40, 0.25 * 40, 2 * c.direction[i]);
    EXPECT_NEAR(std::log(4.0) * found[0][i] + 1 * found[1][i], loose, 1e-12) << i;
  }
  EXPECT_EQ(found[0][6], 0);  // 0.4 mm is the end of it
}

}  // namespace
}  // namespace host_sim::effects::testing
