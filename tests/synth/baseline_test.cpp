#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "tests/synth/support.hpp"

namespace host_sim::synth::test {
namespace {

TEST(SynthBaseline, LeavesNothingWithoutEffectAndNoise) {
  expect_residuals(session(kRecordings), 1e-13, [](std::size_t, double) { return 0.0; });
}

TEST(SynthBaseline, TheCurrentStandsForTheInputTension) {
  const Channels channels = session(kRecordings);
  for (std::size_t i = 0; i < channels[kTime].size(); ++i) {
    ASSERT_NEAR(current_tension_N(channels[kMotorCurrentColumn][i]),
                channels[kInputTensionColumn][i], 1e-11);
  }
}

TEST(SynthBaseline, MovesAsThePlanSays) {
  const Channels channels = session(kRecordings);
  for (std::size_t i = 0; i < channels[kTime].size(); ++i) {
    const double t = static_cast<double>(i) / 200;
    const double c = std::cos(kRate_rad_s * t);
    ASSERT_NEAR(channels[kTime][i], t, 1e-12);
    ASSERT_NEAR(channels[kOutputTensionColumn][i], 30 - 10 * c, 1e-11);
    ASSERT_NEAR(channels[kTendonVelocity][i], kStroke_m * kRate_rad_s * std::sin(kRate_rad_s * t),
                1e-13);
    ASSERT_NEAR(channels[kMotorAngle][i], -kStroke_m * c * 9 / 0.0125, 1e-11);
    ASSERT_NEAR(channels[kBendAngle][i], 270, 1e-11);
  }
}

TEST(SynthBaseline, ConstantSpeedIsTheDerivativeOfItsPosition) {
  const Channels channels = session(kRecordings + "motion = \"constant_speed\"\n");
  const auto& angle = channels[kMotorAngle];
  const auto& velocity = channels[kTendonVelocity];
  double fastest = 0;
  for (std::size_t i = 1; i + 1 < angle.size(); ++i) {
    const double slope = (angle[i + 1] - angle[i - 1]) * 200 / 2 * 0.0125 / 9;
    ASSERT_NEAR(velocity[i], slope, 2e-3) << i;
    fastest = std::max(fastest, std::abs(velocity[i]));
  }
  EXPECT_NEAR(angle[200] * 0.0125 / 9, kStroke_m, 1e-12);
  // A triangle goes 80 mm in 2 s at 40 mm/s, a sine at 62.8 mm/s at most.
  EXPECT_LT(fastest, 0.046);
  EXPECT_GT(fastest, 0.040);
}

TEST(SynthBaseline, PoseSwaysAboutItsAngle) {
  const Channels channels = session(kRecordings + "pose_sway_deg = 5.0\npose_sway_Hz = 0.25\n");
  EXPECT_NEAR(channels[kBendAngle][200], 275, 1e-9);
  EXPECT_NEAR(channels[kBendAngle][600], 265, 1e-9);
  // The capstan equation takes the angle of the moment.
  EXPECT_NEAR(std::log(channels[kInputTensionColumn][200] / channels[kOutputTensionColumn][200]),
              kMu * 275 * std::numbers::pi / 180, 1e-9);
}

RC_GTEST_PROP(SynthBaseline, LeavesNothingAtAnySetting, ()) {
  const int pose_deg = *rc::gen::inRange(0, 900);
  const int mean_N = *rc::gen::inRange(5, 60);
  const int amplitude_N = *rc::gen::inRange(0, mean_N);
  const int frequency_mHz = *rc::gen::inRange(100, 5000);
  const std::string text = fmt::format(
      "[recordings]\nbend_angles_deg = {}\noutput_means_N = {}\noutput_amplitudes_N = {}\n"
      "frequencies_Hz = {}\ntravels_mm = 30\nsample_rate_Hz = 100\nduration_s = 0.5\n",
      pose_deg, mean_N, amplitude_N, frequency_mHz / 1000.0);
  const Channels channels = session(text);
  const std::vector<double> s = directions(channels);
  for (std::size_t i = 0; i < s.size(); ++i) {
    const double r = std::log(channels[kOutputTensionColumn][i]) -
                     std::log(channels[kInputTensionColumn][i]) +
                     kMu * pose_deg * std::numbers::pi / 180 * s[i];
    RC_ASSERT(std::abs(r) < 1e-12);
  }
}

}  // namespace
}  // namespace host_sim::synth::test
