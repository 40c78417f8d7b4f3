#include "host_sim/diagnose/force/smoothing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace host_sim::diagnose {
namespace {

constexpr double kSensorNoise_N = 0.5;

/// Six seconds at 100 Hz of a force that a sensor reads with noise.
effects::ForceRecord read(double (*output_N)(double time_s)) {
  std::mt19937 engine(5);
  std::normal_distribution<double> noise(0, kSensorNoise_N);
  effects::ForceRecord record;
  for (int i = 0; i < 600; ++i) {
    const double time_s = 0.01 * i;
    record.time_s.push_back(time_s);
    record.output_N.push_back(output_N(time_s) + noise(engine));
  }
  record.output_rate_N_s.assign(600, 0);
  record.position_m.assign(600, 0);
  record.reversal_m.assign(600, 0);
  record.used.assign(600, true);
  return record;
}

double off_N(const effects::ForceRecord& record, double (*output_N)(double time_s)) {
  double square_N2 = 0;
  for (std::size_t i = 0; i < record.samples(); ++i) {
    square_N2 += std::pow(record.output_N[i] - output_N(record.time_s[i]), 2);
  }
  return std::sqrt(square_N2 / static_cast<double>(record.samples()));
}

double waving_N(double time_s) {
  return 30 + 10 * std::sin(2 * time_s);
}

/// By a cubic over 33 samples a sample counts 0.0683 at its own place (Savitzky and Golay, 1964,
/// table I by their equation): so much of the variance of the noise is left.
TEST(Smoothing, TakesOutNoiseOfASmoothForce) {
  std::vector<effects::ForceRecord> records{read(waving_N)};
  const double noise_N2 = kSensorNoise_N * kSensorNoise_N;
  EXPECT_NEAR(smooth_output(records), 0.0683 * noise_N2, 0.15 * 0.0683 * noise_N2);
  EXPECT_NEAR(off_N(records[0], waving_N), std::sqrt(0.0683) * kSensorNoise_N,
              0.1 * kSensorNoise_N);
  // d/dt of the sine at a second.
  EXPECT_NEAR(records[0].output_rate_N_s[100], 20 * std::cos(2.0), 3);
}

/// A force that steps every tenth of a second is foreseen by no sample around it.
double stepping_N(double time_s) {
  return std::fmod(std::floor(10 * time_s) * 7.3, 11.0) * 5;
}

TEST(Smoothing, LeavesAForceWithStepsAsItIs) {
  std::vector<effects::ForceRecord> records{read(stepping_N)};
  const std::vector<double> before_N = records[0].output_N;
  EXPECT_GT(smooth_output(records), kSensorNoise_N * kSensorNoise_N);
  EXPECT_EQ(records[0].output_N, before_N);
}

/// What does not count does not spread: neither does it change nor its neighbours by it.
TEST(Smoothing, DoesNotSpreadAFault) {
  std::vector<effects::ForceRecord> records{read(waving_N)};
  for (std::size_t i = 300; i < 303; ++i) {
    records[0].output_N[i] = 1e6;
    records[0].used[i] = false;
  }
  smooth_output(records);
  EXPECT_EQ(records[0].output_N[301], 1e6);
  EXPECT_NEAR(records[0].output_N[299], waving_N(2.99), 2 * kSensorNoise_N);
  EXPECT_NEAR(records[0].output_N[303], waving_N(3.03), 2 * kSensorNoise_N);
}

TEST(Smoothing, ThinningKeepsEachSoManySamples) {
  effects::ForceRecord record = read(waving_N);
  const std::vector<double> before_N = record.output_N;
  thin(record, 150);
  ASSERT_EQ(record.samples(), 150U);
  EXPECT_EQ(record.output_N[7], before_N[28]);
  EXPECT_EQ(record.used.size(), 150U);
  // No more than twice as many are left.
  effects::ForceRecord other = read(waving_N);
  thin(other, 301);
  EXPECT_EQ(other.samples(), 600U);
}

/// Of 1, 2, 3, 2, 1, 0, 1, 2 and 3 mm the first and the fourth of each three are kept: the motion
/// turned at 3 mm between 1 and 2 mm, and at -0.2 mm, before any sample showed it, between 2 and 1.
TEST(Smoothing, ThinningKeepsWhereTheMotionTurned) {
  effects::ForceRecord record;
  for (const double place_m : {1e-3, 2e-3, 3e-3, 2e-3, 1e-3, 0.0, 1e-3, 2e-3, 3e-3}) {
    record.time_s.push_back(0);
    record.position_m.push_back(place_m);
  }
  record.reversal_m = record.position_m;
  record.reversal_m[6] = -0.2e-3;
  record.used.assign(9, true);
  thin(record, 3);
  EXPECT_EQ(record.position_m, (std::vector<double>{1e-3, 2e-3, 1e-3}));
  EXPECT_EQ(record.reversal_m, (std::vector<double>{1e-3, 3e-3, -0.2e-3}));
}

}  // namespace
}  // namespace host_sim::diagnose
