#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "host_sim/statistics/random.hpp"
#include "tests/effects/trace.hpp"

namespace host_sim::effects::testing {
namespace {

constexpr double kNoise_sd = 0.05;
constexpr std::size_t kSamples = 40'000;

/// Standard normal, of two uniform numbers (Box and Muller).
double normal(statistics::Random& random) {
  const double radius = std::sqrt(-2 * std::log(random.uniform()));
  return radius * std::cos(2 * std::numbers::pi * random.uniform());
}

/// 30 N pulled at one bend angle, where the baseline holds; both ends measured with
/// noise of the same size.
recording::Covariates noisy() {
  recording::Covariates c;
  statistics::Random random(3, 0, 0);
  for (std::size_t i = 0; i < kSamples; ++i) {
    const double input_N = 30 * std::exp(kNoise_sd * normal(random));
    c.time_s.push_back(0.01 * static_cast<double>(i));
    c.direction.push_back(1);
    c.bend_angle_rad.push_back(2);
    c.current_A.push_back(input_N / 21);
    c.current_tension_N.push_back(input_N);
    c.output_tension_N.push_back(30 * std::exp(kNoise_sd * normal(random) - 2 * kMu));
  }
  return c;
}

class NoiseOfTheInput : public ::testing::TestWithParam<const char*> {};

/// A signature that divides by the measured input carries its noise, as r does: the correlation of
/// both is 1/sqrt(2) in magnitude for b/i where nothing but noise is left.
TEST_P(NoiseOfTheInput, DoesNotLookLikeTheEffect) {
  const recording::Covariates c = noisy();
  const std::vector<double> column = columns(GetParam(), c).front();
  double sum = 0;
  double square = 0;
  double both = 0;
  double residual_square = 0;
  for (const double value : column) {
    sum += value;
  }
  for (std::size_t i = 0; i < kSamples; ++i) {
    const double r = std::log(c.output_tension_N[i] / c.current_tension_N[i]) + kMu * 2;
    const double value = column[i] - sum / kSamples;
    both += value * r;
    square += value * value;
    residual_square += r * r;
  }
  // Without correlation, its estimate has a standard error of 1/sqrt(samples).
  EXPECT_NEAR(both / std::sqrt(square * residual_square), 0, 4 / std::sqrt(kSamples)) << GetParam();
}

INSTANTIATE_TEST_SUITE_P(Signatures, NoiseOfTheInput,
                         ::testing::Values("current_offset", "friction_preload", "friction_load"));

}  // namespace
}  // namespace host_sim::effects::testing
