#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/effects/trace.hpp"

namespace host_sim::effects::testing {
namespace {

double angle(const recording::Covariates& c, std::size_t i) {
  return c.bend_angle_rad[i] * c.direction[i];
}

/// T_out of the capstan law (14) with this friction coefficient.
double capstan(const recording::Covariates& c, std::size_t i, double mu) {
  return c.tension_in_N()[i] * std::exp(-mu * angle(c, i));
}

/// One sample: pulling 2 rad, T_in 100 N, cycle 4000, sheath at 30 C.
recording::Covariates pulling_sample() {
  recording::Covariates c;
  c.time_s = {0};
  c.cycle = {4000};
  c.direction = {1};
  c.velocity_m_s = {0.02};
  c.bend_angle_rad = {2};
  c.input_tension_N = {100};
  c.output_tension_N = {100 * std::exp(-kMu * 2)};
  c.travel_m = {0.001};
  c.position_m = {0.01};
  c.log_tension_rate_1_s = {0};
  c.sheath_temperature_C = {30};
  return c;
}

TEST(FrictionWear, MoreFrictionLowersTheOutputWhilePulling) {
  EXPECT_NEAR(columns("friction_wear", pulling_sample(), {0.5, 0})[0][0], -0.128 * 2 * 2, 1e-12);
  EXPECT_NEAR(columns("friction_wear", pulling_sample(), {0, 1000})[0][0],
              -0.128 * 2 * 0.018315638888734179, 1e-12);
}

TEST(FrictionWear, IsTheDerivativeOfThePowerLawAndOfTheRunIn) {
  const recording::Covariates c = trace();
  const auto power = [&](std::size_t i, double a) {
    return capstan(c, i, kMu * (1 + a * std::pow(c.cycle[i] / 1000, 1.5)));
  };
  expect_same(columns("friction_wear", c, {1.5, 0})[0], derivative(c, power, 1e-4), kTolerance);
  const auto run_in = [&](std::size_t i, double a) {
    return capstan(c, i, kMu * (1 + a * std::exp(-c.cycle[i] / 300)));
  };
  expect_same(columns("friction_wear", c, {0, 300})[0], derivative(c, run_in, 1e-4), kTolerance);
}

TEST(FrictionTemperature, IsTheDerivative) {
  EXPECT_NEAR(columns("friction_temperature", pulling_sample())[0][0], -0.128 * 2 * 10, 1e-12);
  const recording::Covariates c = trace();
  const auto output = [&](std::size_t i, double k) {
    return capstan(c, i, kMu * (1 + k * (c.sheath_temperature_C[i] - 20)));
  };
  expect_same(columns("friction_temperature", c)[0], derivative(c, output, 1e-5), kTolerance);
}

TEST(FrictionVelocity, IsTheDerivativeInBothParameters) {
  const std::vector<double> shape{0.02};
  EXPECT_NEAR(columns("friction_velocity", pulling_sample(), shape)[0][0], -2 * std::exp(-1.0),
              1e-12);
  EXPECT_NEAR(columns("friction_velocity", pulling_sample(), shape)[1][0], -2 * 0.02, 1e-12);
  const recording::Covariates c = trace();
  const auto stribeck = [&](std::size_t i, double above) {
    return capstan(c, i, kMu + above * std::exp(-std::abs(c.velocity_m_s[i]) / 0.02));
  };
  expect_same(columns("friction_velocity", c, shape)[0], derivative(c, stribeck, 1e-4), kTolerance);
  const auto viscous = [&](std::size_t i, double kappa) {
    return capstan(c, i, kMu + kappa * std::abs(c.velocity_m_s[i]));
  };
  expect_same(columns("friction_velocity", c, shape)[1], derivative(c, viscous, 1e-3), kTolerance);
}

/// The sheath in 4000 steps: d ln T/d phi = -mu (T/50)^-k s, by the midpoint rule.
double along_sheath(double input_N, double bend_angle_rad, double direction, double exponent) {
  constexpr int kSteps = 4000;
  const double step = bend_angle_rad / kSteps;
  double log_N = std::log(input_N);
  const auto slope = [&](double at) {
    return -kMu * direction * std::exp(-exponent * (at - std::log(50.0)));
  };
  for (int k = 0; k < kSteps; ++k) {
    log_N += step * slope(log_N + step / 2 * slope(log_N));
  }
  return std::exp(log_N);
}

TEST(FrictionLoad, IsTheLawAtEachPlaceOfTheSheathWhateverItsSize) {
  // With k = 1/2 the roots of the tensions fall evenly: from 10 by mu phi sqrt(50)/2.
  const double root = 10 - 0.128 * 2 * std::sqrt(50.0) / 2;
  recording::Covariates sample = pulling_sample();
  sample.output_tension_N = {root * root};
  EXPECT_NEAR(columns("friction_load", sample, {0.5})[0][0],
              std::log(root * root / 100) + 0.128 * 2, 1e-12);
  for (const double exponent : {-0.8, -0.2, 0.3, 0.8}) {
    recording::Covariates c = trace();
    std::vector<double> exact;
    for (std::size_t i = 0; i < c.samples(); ++i) {
      c.output_tension_N[i] =
          along_sheath(c.current_tension_N[i], c.bend_angle_rad[i], c.direction[i], exponent);
      exact.push_back(std::log(c.output_tension_N[i] / c.current_tension_N[i]) +
                      kMu * c.bend_angle_rad[i] * c.direction[i]);
    }
    expect_same(columns("friction_load", c, {exponent})[0], exact, 1e-6);
  }
}

TEST(FrictionPreload, IsAForceAgainstTheMotionWhateverItsSize) {
  recording::Covariates sample = pulling_sample();
  sample.output_tension_N = {64 * std::exp(-kMu * 2)};  // 36 N of 100 are lost
  EXPECT_NEAR(columns("friction_preload", sample, {36})[0][0], std::log(0.64), 1e-14);
  const recording::Covariates c = trace();
  for (const double force_N : {0.3, 5.0, 15.0}) {
    const recording::Covariates held = with_output(c, [&](std::size_t i) {
      return (c.current_tension_N[i] - force_N * c.direction[i]) * std::exp(-kMu * angle(c, i));
    });
    expect_same(columns("friction_preload", held, {force_N})[0], residuals(held), 1e-13);
  }
}

TEST(FrictionPosition, IsTheDerivativeInEachHarmonic) {
  // x = 10 mm of 40 mm: a quarter turn, so sin 1, cos 0; then 0, -1; -1, 0; 0, 1; 1, 0; 0, -1
  const auto at_quarter = columns("friction_position", pulling_sample(), {0.04});
  const double friction = -0.128 * 2;
  const std::vector<double> expected{friction, 0, 0, -friction, -friction, 0, 0, friction,
                                     friction, 0, 0, -friction, friction,  0, 0, -friction};
  ASSERT_EQ(at_quarter.size(), expected.size());
  for (std::size_t j = 0; j < expected.size(); ++j) {
    EXPECT_NEAR(at_quarter[j][0], expected[j], 1e-12) << j;
  }
  const recording::Covariates c = trace();
  const auto found = columns("friction_position", c, {0.02});
  for (int h = 1; h <= 6; ++h) {
    const auto turn = [&](std::size_t i) {
      return 2 * std::numbers::pi * h * c.position_m[i] / 0.02;
    };
    const auto sine = [&](std::size_t i, double a) {
      return capstan(c, i, kMu * (1 + a * std::sin(turn(i))));
    };
    const auto cosine = [&](std::size_t i, double b) {
      return capstan(c, i, kMu * (1 + b * std::cos(turn(i))));
    };
    const auto first = static_cast<std::size_t>(2 * (h - 1));
    expect_same(found[first], derivative(c, sine, 1e-4), kTolerance);
    expect_same(found[first + 1], derivative(c, cosine, 1e-4), kTolerance);
  }
}

/// mu (1 + h(x) s): more while pulling where h is positive, less while letting go.
TEST(FrictionPosition, MayDifferByDirection) {
  const recording::Covariates c = trace();
  const auto found = columns("friction_position", c, {0.02});
  ASSERT_EQ(found.size(), 16U);
  for (int h = 1; h <= 2; ++h) {
    const auto sine = [&](std::size_t i, double a) {
      const double turn = 2 * std::numbers::pi * h * c.position_m[i] / 0.02;
      return capstan(c, i, kMu * (1 + a * std::sin(turn) * c.direction[i]));
    };
    const auto cosine = [&](std::size_t i, double b) {
      const double turn = 2 * std::numbers::pi * h * c.position_m[i] / 0.02;
      return capstan(c, i, kMu * (1 + b * std::cos(turn) * c.direction[i]));
    };
    const auto first = static_cast<std::size_t>(12 + 2 * (h - 1));
    expect_same(found[first], derivative(c, sine, 1e-4), kTolerance);
    expect_same(found[first + 1], derivative(c, cosine, 1e-4), kTolerance);
  }
}

TEST(BendAngle, IsTheDerivativeInTheErrorOfEachPose) {
  recording::Covariates c = trace();
  for (std::size_t i = 20; i < c.samples(); ++i) {
    c.bend_angle_rad[i] += 1;
  }
  Baseline baseline = kBaseline;
  baseline.poses_rad = {1.0, 2.12, 3.13};
  const auto found = columns("bend_angle", c, {}, baseline);
  ASSERT_EQ(found.size(), 3U);
  const auto output = [&](std::size_t pose) {
    return [&c, pose](std::size_t i, double error_rad) {
      const bool here = i < 20 ? pose == 1 : pose == 2;
      const double angle_rad = c.bend_angle_rad[i] + (here ? error_rad : 0);
      return c.current_tension_N[i] * std::exp(-kMu * angle_rad * c.direction[i]);
    };
  };
  EXPECT_EQ(found[0], std::vector<double>(c.samples(), 0.0));
  expect_same(found[1], derivative(c, output(1), 1e-4), kTolerance);
  expect_same(found[2], derivative(c, output(2), 1e-4), kTolerance);
}

TEST(BendAngle, HasOneColumnWhereNoPosesAreGiven) {
  EXPECT_EQ(columns("bend_angle", pulling_sample()), (std::vector<std::vector<double>>{{-0.128}}));
}

}  // namespace
}  // namespace host_sim::effects::testing
