#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "host_sim/synth/campaign/sessions.hpp"
#include "host_sim/synth/plan/plan.hpp"
#include "tests/io/support.hpp"

namespace host_sim::synth::test {

using host_sim::test::complaint_of;

inline constexpr double kMu = 0.128;
inline constexpr double kPhi_rad = 270 * std::numbers::pi / 180;
inline constexpr double kFull = kMu * kPhi_rad;
inline constexpr double kRate_rad_s = std::numbers::pi;  // of 0.5 Hz
inline constexpr double kStroke_m = 0.02;                // half the travel

inline const std::string kModel = R"(
[campaign]
name = "small"
[model.cable]
diameter_mm = 0.457
ultimate_tension_N = 177.4
[model.sheath]
friction_coefficient = 0.128
bend_angle_deg = 270.0
[model.drive]
torque_constant_Nm_per_A = 0.0325
gear_ratio = 9.0
gear_efficiency = 0.88
spool_radius_mm = 12.5
current_offset_A = 0.0
[model.life]
mean_stress = "gerber"
ipl_scale = 1.53e5
ipl_exponent = 1.38
weibull_shape = 5.94
)";

/// One session: 270 deg, 30 +- 10 N, 0.5 Hz, 40 mm, 200 samples a second.
inline const std::string kRecordings = R"(
[recordings]
bend_angles_deg = 270.0
output_means_N = 30.0
output_amplitudes_N = 10.0
frequencies_Hz = 0.5
travels_mm = 40.0
sample_rate_Hz = 200.0
duration_s = 4.0
)";

inline SynthPlan plan_of(const std::string& text) {
  return parse_synth_plan(kModel + text, "plan");
}

/// What the sensors say in one session of a plan.
inline Channels session(const std::string& text, std::size_t number = 0, std::uint64_t seed = 1) {
  const SynthPlan plan = plan_of(text);
  const Setting setting = settings_of(*plan.recordings, seed).at(number);
  return session_channels(plan, setting, session_scatter(plan, seed, number), seed);
}

inline double time_of(std::size_t i) {
  return static_cast<double>(i) / 200;
}

/// s of each sample, as the motion of kRecordings has it.
inline std::vector<double> directions(const Channels& channels) {
  std::vector<double> result;
  double last = 1;
  for (const double v : channels[hal::files::kTendonVelocity]) {
    last = v > 0 ? 1 : v < 0 ? -1 : last;
    result.push_back(last);
  }
  return result;
}

/// r = ln T_out - ln T_in + mu phi s of each sample.
inline std::vector<double> residuals(const Channels& channels) {
  const std::vector<double> s = directions(channels);
  std::vector<double> result;
  for (std::size_t i = 0; i < s.size(); ++i) {
    result.push_back(std::log(channels[hal::files::kOutputTensionColumn][i]) -
                     std::log(channels[hal::files::kInputTensionColumn][i]) +
                     kMu * kPhi_rad * s[i]);
  }
  return result;
}

/// T_in that the motor current stands for by the nominal drive.
inline double current_tension_N(double current_A) {
  return 0.0325 * current_A * 9 * 0.88 / 0.0125;
}

/// Compares r of every sample with what `expected(i, channels, s)` says.
template <class Expected>
void expect_residuals(const Channels& channels, double tolerance, const Expected& expected) {
  const std::vector<double> r = residuals(channels);
  const std::vector<double> s = directions(channels);
  ASSERT_EQ(r.size(), 800U);
  for (std::size_t i = 0; i < r.size(); ++i) {
    ASSERT_NEAR(r[i], expected(i, s[i]), tolerance) << "sample " << i;
  }
}

}  // namespace host_sim::synth::test
