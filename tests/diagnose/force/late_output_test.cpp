#include "host_sim/diagnose/force/late_output.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace host_sim::diagnose {
namespace {

constexpr double kFriction = 0.1;
constexpr double kPreload_N = 3;

/// A tendon whose force has parts of 0.9 and 2.3 turns a second; its output is read late.
struct Late {
  double lag_s = 0;
  double delay_s = 0;
  double noise_N = 0.1;

  [[nodiscard]] std::vector<effects::ForceRecord> measured(unsigned seed) const {
    std::mt19937 engine(seed);
    std::normal_distribution<double> noise(0, noise_N);
    std::vector<effects::ForceRecord> records;
    for (int j = 0; j < 12; ++j) {
      effects::ForceRecord record;
      record.session = "s" + std::to_string(j);
      const double omega = 2 * std::numbers::pi * (0.2 + 0.03 * j);
      for (int i = 0; i < 1000; ++i) {
        const double t = 0.01 * i;
        const double slip = std::tanh(0.05 * omega * std::cos(omega * t) / 1e-3);
        const double load_N = read_N(t, j, 0, 0);
        record.time_s.push_back(t);
        record.position_m.push_back(0.05 * std::sin(omega * t));
        record.velocity_m_s.push_back(0.05 * omega * std::cos(omega * t));
        record.output_N.push_back(read_N(t, j, lag_s, delay_s) + noise(engine));
        record.output_rate_N_s.push_back(0);  // smoothing has it
        record.input_N.push_back(load_N * std::exp(kFriction * std::numbers::pi * slip) +
                                 kPreload_N * slip + noise(engine));
        record.bend_angle_rad.push_back(std::numbers::pi);
        record.used.push_back(true);
        record.measured.push_back(true);
      }
      record.pulls_alone = true;
      record.reversal_m = reversals_m(record);
      records.push_back(std::move(record));
    }
    return records;
  }

 private:
  /// What a first-order lag makes of each part: its amplitude over (1 + (w tau)^2)^1/2.
  static double read_N(double t, int session, double lag_s, double delay_s) {
    double force_N = 60;
    for (const double hertz : {0.9, 2.3}) {
      const double w = 2 * std::numbers::pi * hertz;
      force_N += 10 / std::hypot(1, w * lag_s) *
                 std::sin(w * (t - delay_s) - std::atan(w * lag_s) + session * hertz);
    }
    return force_N;
  }
};

/// Beside a model that is fitted with a lag, whatever it is.
LateOutput found(const Late& late, unsigned seed) {
  const std::vector<effects::ForceRecord> records = late.measured(seed);
  ForceData data(records);
  const ForceFit nominal = data.fit({}, {1, kFriction}, 15);
  const ForceFit lagging = data.fit({effects::ForceTerm::preload, effects::ForceTerm::lag},
                                    {1, kFriction, kPreload_N, late.lag_s + late.delay_s}, 15);
  return late_output(data.as_sampled(records, nominal, lagging), records, lagging);
}

TEST(LateOutput, ALagOfTheSensorIsSeenAsOne) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const LateOutput late = found({.lag_s = 0.012}, seed);
    EXPECT_NEAR(late.as_delay, 0, 0.25) << seed;
    EXPECT_LT(late.error, 0.15);
  }
}

TEST(LateOutput, ADelayOfTheSensorIsSeenAsOne) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const LateOutput late = found({.delay_s = 0.012}, seed);
    EXPECT_NEAR(late.as_delay, 1, 0.25) << seed;
    EXPECT_LT(late.error, 0.15);
  }
}

/// Noise is in what a half leaves and in what it shows of the second derivative: of the other half
/// that is another. Each of ten campaigns is within three standard errors.
TEST(LateOutput, NoiseLeavesNoTrace) {
  for (unsigned seed = 11; seed <= 20; ++seed) {
    const LateOutput late = found({.lag_s = 0.012, .noise_N = 2}, seed);
    EXPECT_NEAR(late.as_delay, 0, 3 * late.error) << seed;
    EXPECT_LT(late.error, 1);
  }
}

/// tau^2/2 of the second derivative: a tenth of tau is a hundredth of that, beside the same noise.
TEST(LateOutput, WhatIsLessLateIsLessSurelyOneOfTheTwo) {
  const double late = found({.lag_s = 0.012}, 1).error;
  EXPECT_GT(found({.lag_s = 0.0012}, 1).error, 50 * late);
}

}  // namespace
}  // namespace host_sim::diagnose
