#include <gtest/gtest.h>

#include <cmath>

#include "tests/effects/trace.hpp"

namespace host_sim::effects::testing {
namespace {

constexpr double kTolerance = 1e-6;
constexpr double kNewtonsPerAmpere = 21;  // of trace()

/// T_out where the drive really pulls with `input_N`.
double output(const recording::Covariates& c, std::size_t i, double input_N) {
  return input_N * std::exp(-kMu * c.bend_angle_rad[i] * c.direction[i]);
}

/// One sample: letting go, 2 A, winding at 65 C, rotor at 0.5 rad.
recording::Covariates one_sample() {
  recording::Covariates c;
  c.time_s = {0};
  c.direction = {-1};
  c.bend_angle_rad = {2};
  c.current_A = {2};
  c.current_tension_N = {42};
  c.output_tension_N = {42 * std::exp(kMu * 2)};
  c.motor_angle_rad = {0.5};
  c.winding_temperature_C = {65};
  return c;
}

TEST(CurrentOffset, IsTheDerivative) {
  EXPECT_NEAR(columns("current_offset", one_sample())[0][0], -0.5, 1e-14);
  const recording::Covariates c = trace();
  const auto model = [&](std::size_t i, double offset_A) {
    return output(c, i, kNewtonsPerAmpere * (c.current_A[i] - offset_A));
  };
  expect_same(columns("current_offset", c)[0], derivative(c, model, 1e-4), kTolerance);
}

TEST(TorqueGain, IsTheDerivative) {
  EXPECT_NEAR(columns("torque_gain", one_sample())[0][0], -40, 1e-12);
  const recording::Covariates c = trace();
  const auto model = [&](std::size_t i, double droop_1_K) {
    const double constant = kNewtonsPerAmpere * (1 - droop_1_K * (c.winding_temperature_C[i] - 25));
    return output(c, i, constant * c.current_A[i]);
  };
  expect_same(columns("torque_gain", c)[0], derivative(c, model, 1e-6), kTolerance);
}

TEST(GearAsymmetry, IsTheDerivative) {
  EXPECT_NEAR(columns("gear_asymmetry", one_sample())[0][0], -1, 1e-15);
  const recording::Covariates c = trace();
  const auto model = [&](std::size_t i, double asymmetry) {
    return output(c, i, c.current_tension_N[i] * (1 + asymmetry * c.direction[i]));
  };
  expect_same(columns("gear_asymmetry", c)[0], derivative(c, model, 1e-4), kTolerance);
}

TEST(TorqueRipple, IsTheDerivativeInSineAndCosine) {
  EXPECT_NEAR(columns("torque_ripple", one_sample(), {6})[0][0], std::sin(3.0) / 2, 1e-15);
  EXPECT_NEAR(columns("torque_ripple", one_sample(), {6})[1][0], std::cos(3.0) / 2, 1e-15);
  const recording::Covariates c = trace();
  const auto sine = [&](std::size_t i, double a) {
    return output(c, i,
                  kNewtonsPerAmpere * (c.current_A[i] + a * std::sin(6 * c.motor_angle_rad[i])));
  };
  const auto cosine = [&](std::size_t i, double b) {
    return output(c, i,
                  kNewtonsPerAmpere * (c.current_A[i] + b * std::cos(6 * c.motor_angle_rad[i])));
  };
  expect_same(columns("torque_ripple", c, {6})[0], derivative(c, sine, 1e-4), kTolerance);
  expect_same(columns("torque_ripple", c, {6})[1], derivative(c, cosine, 1e-4), kTolerance);
}

}  // namespace
}  // namespace host_sim::effects::testing
