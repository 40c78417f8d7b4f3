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
template <class Output>
effects::ForceRecord read(const Output& output_N) {
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
  record.measured.assign(600, true);
  return record;
}

template <class Output>
double off_N(const effects::ForceRecord& record, const Output& output_N) {
  double square_N2 = 0;
  for (std::size_t i = 0; i < record.samples(); ++i) {
    square_N2 += std::pow(record.output_N[i] - output_N(record.time_s[i]), 2);
  }
  return std::sqrt(square_N2 / static_cast<double>(record.samples()));
}

double waving_N(double time_s) {
  return 30 + 10 * std::sin(2 * time_s);
}

/// By a quintic over 33 samples a sample counts 0.107 at its own place (Savitzky and Golay, 1964,
/// table II by their equation): so much of the variance of the noise is left.
TEST(Smoothing, TakesOutNoiseOfASmoothForce) {
  effects::ForceRecord record = read(waving_N);
  const double noise_N2 = kSensorNoise_N * kSensorNoise_N;
  EXPECT_NEAR(smooth_output(record).force_N2, 0.107 * noise_N2, 0.15 * 0.107 * noise_N2);
  EXPECT_NEAR(off_N(record, waving_N), std::sqrt(0.107) * kSensorNoise_N, 0.1 * kSensorNoise_N);
  // d/dt of the sine at a second.
  EXPECT_NEAR(record.output_rate_N_s[100], 20 * std::cos(2.0), 3);
}

/// A wave of 0.28 s is no smaller by it than noise lets that be seen: by cubics over 17 samples it
/// would be by 3.7 %, 0.37 N, and change as much slower.
TEST(Smoothing, LeavesAFastWaveAsLargeAsItIs) {
  const auto fast_N = [](double time_s) { return 30 + 10 * std::sin(22 * time_s); };
  effects::ForceRecord record = read(fast_N);
  smooth_output(record);
  EXPECT_LT(off_N(record, fast_N), kSensorNoise_N);
  double amplitude_N = 0;
  double rate_N_s = 0;
  for (std::size_t i = 0; i < record.samples(); ++i) {
    amplitude_N += (record.output_N[i] - 30) * std::sin(22 * record.time_s[i]) / 300;
    rate_N_s += record.output_rate_N_s[i] * std::cos(22 * record.time_s[i]) / 300;
  }
  EXPECT_NEAR(amplitude_N, 10, 0.1);
  EXPECT_NEAR(rate_N_s, 220, 2.2);
}

/// Noise of which a sample has 0.4 of the one before is taken out less: what is left is as large as
/// it is said to be.
TEST(Smoothing, KnowsWhatIsLeftOfNoiseThatIsCorrelated) {
  double left_N2 = 0;
  double off_N2 = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    std::mt19937 engine(seed);
    std::normal_distribution<double> normal;
    effects::ForceRecord record = read(waving_N);
    double noise_N = 0;
    for (std::size_t i = 0; i < record.samples(); ++i) {
      noise_N = 0.4 * noise_N + std::sqrt(1 - 0.16) * kSensorNoise_N * normal(engine);
      record.output_N[i] = waving_N(record.time_s[i]) + noise_N;
    }
    left_N2 += smooth_output(record).force_N2;
    off_N2 += std::pow(off_N(record, waving_N), 2);
  }
  EXPECT_NEAR(left_N2, off_N2, 0.2 * off_N2);
}

/// A force that steps every tenth of a second is foreseen by no sample around it.
double stepping_N(double time_s) {
  return std::fmod(std::floor(10 * time_s) * 7.3, 11.0) * 5;
}

TEST(Smoothing, LeavesAForceWithStepsAsItIs) {
  effects::ForceRecord record = read(stepping_N);
  const std::vector<double> before_N = record.output_N;
  EXPECT_GT(smooth_output(record).force_N2, kSensorNoise_N * kSensorNoise_N);
  EXPECT_EQ(record.output_N, before_N);
}

/// What was not measured does not spread: neither does it change nor its neighbours by it.
TEST(Smoothing, DoesNotSpreadAFault) {
  effects::ForceRecord record = read(waving_N);
  for (std::size_t i = 300; i < 303; ++i) {
    record.output_N[i] = 1e6;
    record.measured[i] = false;
  }
  smooth_output(record);
  EXPECT_EQ(record.output_N[301], 1e6);
  EXPECT_NEAR(record.output_N[299], waving_N(2.99), 2 * kSensorNoise_N);
  EXPECT_NEAR(record.output_N[303], waving_N(3.03), 2 * kSensorNoise_N);
}

/// A sheath that warms by 2 K in a minute changes by a quintic over 65 samples: 0.054 of the
/// variance of the noise is left.
TEST(Smoothing, TakesOutNoiseOfTemperatures) {
  effects::ForceRecord record = read(waving_N);
  std::mt19937 engine(8);
  std::normal_distribution<double> noise_C(0, 0.4);
  for (const double time_s : record.time_s) {
    record.sheath_temperature_C.push_back(20 + time_s / 30 + noise_C(engine));
  }
  smooth_temperatures(record);
  double square_K2 = 0;
  for (std::size_t i = 0; i < record.samples(); ++i) {
    square_K2 += std::pow(record.sheath_temperature_C[i] - 20 - record.time_s[i] / 30, 2);
  }
  EXPECT_NEAR(square_K2 / 600, 0.054 * 0.16, 0.5 * 0.054 * 0.16);
  EXPECT_TRUE(record.winding_temperature_C.empty());
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
  record.measured.assign(9, true);
  thin(record, 3);
  EXPECT_EQ(record.position_m, (std::vector<double>{1e-3, 2e-3, 1e-3}));
  EXPECT_EQ(record.reversal_m, (std::vector<double>{1e-3, 3e-3, -0.2e-3}));
}

}  // namespace
}  // namespace host_sim::diagnose
