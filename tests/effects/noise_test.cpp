#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "host_sim/statistics/random.hpp"
#include "tests/effects/trace.hpp"

namespace host_sim::effects::testing {
namespace {

constexpr double kNoise_sd = 0.01;  // as load cells have it
constexpr std::size_t kNoisySamples = 40'000;

/// Standard normal, of two uniform numbers (Box and Muller).
double normal(statistics::Random& random) {
  const double radius = std::sqrt(-2 * std::log(random.uniform()));
  return radius * std::cos(2 * std::numbers::pi * random.uniform());
}

/// d ln T/dt over two samples to each side, fewer at the ends.
std::vector<double> central_differences(const std::vector<double>& tension_N, double step_s) {
  std::vector<double> rates_1_s;
  for (std::size_t i = 0; i < tension_N.size(); ++i) {
    const std::size_t from = i - std::min<std::size_t>(i, 2);
    const std::size_t to = std::min(i + 2, tension_N.size() - 1);
    rates_1_s.push_back(std::log(tension_N[to] / tension_N[from]) /
                        (static_cast<double>(to - from) * step_s));
  }
  return rates_1_s;
}

/// A triangle of 50 samples each way at 20 mm/s and one bend angle, of 30 N, where the baseline
/// holds; both ends measured with noise of the same size.
recording::Covariates noisy() {
  constexpr double kSampleStep_s = 0.01;
  constexpr double kSpeed_m_s = 0.02;
  recording::Covariates c;
  statistics::Random random(3, 0, 0);
  double position_m = 0;
  for (std::size_t i = 0; i < kNoisySamples; ++i) {
    const double direction = (i / 50) % 2 == 0 ? 1 : -1;
    const double input_N = 30 * std::exp(kNoise_sd * normal(random));
    position_m += i == 0 ? 0 : direction * kSpeed_m_s * kSampleStep_s;
    c.time_s.push_back(kSampleStep_s * static_cast<double>(i));
    c.direction.push_back(direction);
    c.velocity_m_s.push_back(direction * kSpeed_m_s);
    c.position_m.push_back(position_m);
    c.motor_angle_rad.push_back(720 * position_m);
    c.bend_angle_rad.push_back(2);
    c.current_A.push_back(input_N / 21);
    c.current_tension_N.push_back(input_N);
    c.output_tension_N.push_back(30 * std::exp(kNoise_sd * normal(random) - 2 * kMu * direction));
  }
  c.log_output_rate_1_s = central_differences(c.output_tension_N, kSampleStep_s);
  return c;
}

double mean_where(const std::vector<double>& directions, double direction,
                  const std::vector<double>& values) {
  double sum = 0;
  double count = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    sum += directions[i] == direction ? values[i] : 0;
    count += directions[i] == direction ? 1 : 0;
  }
  return sum / count;
}

struct Case {
  const char* id;
  std::vector<double> shape;
};

class NoiseOfBothEnds : public ::testing::TestWithParam<Case> {};

/// A signature that divides by one measured end carries its noise, as r does: the correlation of
/// both is 1/sqrt(2) in magnitude for b/i where nothing but noise is left. What gain and friction
/// take up, the mean of each direction, is taken off.
TEST_P(NoiseOfBothEnds, DoesNotLookLikeTheEffect) {
  const recording::Covariates c = noisy();
  const std::vector<double> residual = residuals(c);
  for (const std::vector<double>& column : columns(GetParam().id, c, GetParam().shape)) {
    for (const double direction : {1.0, -1.0}) {
      const double mean = mean_where(c.direction, direction, column);
      double square = 0;
      double both = 0;
      double residual_square = 0;
      for (std::size_t i = 0; i < kNoisySamples; ++i) {
        if (c.direction[i] == direction) {
          both += (column[i] - mean) * residual[i];
          square += (column[i] - mean) * (column[i] - mean);
          residual_square += residual[i] * residual[i];
        }
      }
      ASSERT_GT(square, 0);
      // Without correlation, its estimate has a standard error of 1/sqrt(samples), of half of all.
      EXPECT_NEAR(both / std::sqrt(square * residual_square), 0, 4 / std::sqrt(kNoisySamples / 2));
    }
  }
}

std::string name_of(const ::testing::TestParamInfo<Case>& info) {
  std::string name(info.param.id);
  name += '_';
  name += std::to_string(info.index);
  return name;
}

INSTANTIATE_TEST_SUITE_P(
    Signatures, NoiseOfBothEnds,
    ::testing::Values(Case{"compliance", {1e3}}, Case{"compliance", {1e4}},
                      Case{"current_offset", {0.04}}, Case{"current_offset", {-0.32}},
                      Case{"filter_lag", {0.005}}, Case{"filter_lag", {-0.02}},
                      Case{"friction_load", {0.2}}, Case{"friction_preload", {2.5}},
                      Case{"friction_preload", {20}}, Case{"torque_ripple", {6}}),
    name_of);

}  // namespace
}  // namespace host_sim::effects::testing
