#include <gtest/gtest.h>

#include <cmath>

#include "tests/effects/trace.hpp"

namespace host_sim::effects::testing {
namespace {

constexpr double kNewtonsPerAmpere = 21;  // of trace()

/// T_out where the drive really pulls with `input_N`.
double output(const recording::Covariates& c, std::size_t i, double input_N) {
  return input_N * std::exp(-kMu * c.bend_angle_rad[i] * c.direction[i]);
}

/// One sample: letting go, 2 A, winding at 65 C, rotor at 0.5 rad.
recording::Covariates releasing_sample() {
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

TEST(CurrentOffset, IsTheLogarithmOfTheCurrentThatIsLeft) {
  recording::Covariates sample = releasing_sample();
  sample.output_tension_N = {21 * 1.28 * std::exp(kMu * 2)};  // 0.72 A of 2 A are the offset
  EXPECT_NEAR(columns("current_offset", sample, {0.72})[0][0], std::log(0.64), 1e-14);
  const recording::Covariates c = trace();
  for (const double offset_A : {-0.3, 0.01, 0.5}) {
    const recording::Covariates off = with_output(c, [&](std::size_t i) {
      return output(c, i, kNewtonsPerAmpere * (c.current_A[i] - offset_A));
    });
    expect_same(columns("current_offset", off, {offset_A})[0], residuals(off), 1e-13);
  }
}

TEST(TorqueGain, IsTheLogarithmOfTheConstantThatIsLeft) {
  EXPECT_NEAR(columns("torque_gain", releasing_sample(), {0.004})[0][0], std::log(0.84), 1e-14);
  const recording::Covariates c = trace();
  for (const double droop_1_K : {1.5e-4, 2e-3, 5e-3}) {
    const recording::Covariates warm = with_output(c, [&](std::size_t i) {
      const double left = 1 - droop_1_K * (c.winding_temperature_C[i] - 25);
      return output(c, i, kNewtonsPerAmpere * left * c.current_A[i]);
    });
    expect_same(columns("torque_gain", warm, {droop_1_K})[0], residuals(warm), 1e-12);
  }
}

TEST(TorqueGain, StaysFiniteWhereNothingWouldBeLeft) {
  recording::Covariates sample = releasing_sample();
  sample.winding_temperature_C = {400};
  EXPECT_TRUE(std::isfinite(columns("torque_gain", sample, {5e-3})[0][0]));
}

TEST(GearAsymmetry, IsTheDerivative) {
  EXPECT_NEAR(columns("gear_asymmetry", releasing_sample())[0][0], -1, 1e-15);
  const recording::Covariates c = trace();
  const auto model = [&](std::size_t i, double asymmetry) {
    return output(c, i, c.current_tension_N[i] * (1 + asymmetry * c.direction[i]));
  };
  expect_same(columns("gear_asymmetry", c)[0], derivative(c, model, 1e-4), kTolerance);
}

TEST(TorqueRipple, IsTheDerivativeInSineAndCosine) {
  EXPECT_NEAR(columns("torque_ripple", releasing_sample(), {6})[0][0], std::sin(3.0) / 2, 1e-15);
  EXPECT_NEAR(columns("torque_ripple", releasing_sample(), {6})[1][0], std::cos(3.0) / 2, 1e-15);
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

/// ln(1 + q/i) is 2 asinh(q/2m) over the geometric mean m of i and i + q, so that q/m is off by its
/// cube over 24 alone.
TEST(TorqueRipple, IsOffByAThirdOrderWhereItIsLarge) {
  constexpr double kRipple_A = 0.3;
  const recording::Covariates c = trace();
  const auto ripple_A = [&](std::size_t i) {
    return kRipple_A * std::sin(6 * c.motor_angle_rad[i]);
  };
  const recording::Covariates rippled = with_output(c, [&](std::size_t i) {
    return output(c, i, kNewtonsPerAmpere * (c.current_A[i] + ripple_A(i)));
  });
  const std::vector<double> found = columns("torque_ripple", rippled, {6})[0];
  const std::vector<double> exact = residuals(rippled);
  for (std::size_t i = 0; i < c.samples(); ++i) {
    const double size = std::abs(ripple_A(i)) / c.current_A[i] * 1.2;
    EXPECT_NEAR(kRipple_A * found[i], exact[i], size * size * size / 24 + 1e-13) << i;
  }
}

}  // namespace
}  // namespace host_sim::effects::testing
