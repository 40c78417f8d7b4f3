#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <numeric>

#include "tests/synth/support.hpp"

namespace host_sim::synth::test {

using enum hal::files::ProfileColumnId;

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
  // The capstan equation takes the angle of the covariates.
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

constexpr std::size_t kMany = 40'000;

/// The same in proportion at both ends.
Noise alike(double relative_sd, double ar1 = 0, double student_t_dof = 0) {
  const EndNoise end{.relative_sd = relative_sd, .ar1 = ar1};
  return {.output = end, .input = end, .student_t_dof = student_t_dof};
}

/// Ones on all channels but time, with noise.
Channels noisy(const Noise& noise, std::uint64_t seed = 1, std::size_t session = 0) {
  Channels channels;
  for (std::vector<double>& channel : channels) {
    channel.assign(kMany, 1.0);
  }
  for (std::size_t i = 0; i < kMany; ++i) {
    channels[kTime][i] = static_cast<double>(i) / 200;
  }
  add_noise(noise, seed, session, channels);
  return channels;
}

std::vector<double> logs(std::vector<double> values) {
  std::transform(values.begin(), values.end(), values.begin(),
                 [](double value) { return std::log(value); });
  return values;
}

/// Mean of a[i] b[i + lag].
double product(const std::vector<double>& a, const std::vector<double>& b, std::size_t lag = 0) {
  double sum = 0;
  for (std::size_t i = 0; i + lag < a.size(); ++i) {
    sum += a[i] * b[i + lag];
  }
  return sum / static_cast<double>(a.size() - lag);
}

TEST(SynthNoise, NoneLeavesAllAsItIs) {
  const Channels channels = noisy({});
  EXPECT_EQ(channels[kOutputTensionColumn], std::vector<double>(kMany, 1.0));
  EXPECT_EQ(channels[kSheathTemperature], std::vector<double>(kMany, 1.0));
  EXPECT_EQ(channels[kTime][7], 7.0 / 200);
}

TEST(SynthNoise, HasTheStandardDeviationAskedFor) {
  const Channels channels = noisy(alike(0.02));
  for (const auto id : {kOutputTensionColumn, kInputTensionColumn, kMotorCurrentColumn}) {
    const std::vector<double> e = logs(channels[id]);
    // Of n normal numbers: sd / sqrt(2 n), 5 of them; mean sd / sqrt(n).
    EXPECT_NEAR(std::sqrt(product(e, e)), 0.02, 5 * 0.02 / std::sqrt(2.0 * kMany));
    EXPECT_NEAR(std::accumulate(e.begin(), e.end(), 0.0) / kMany, 0, 5 * 0.02 / std::sqrt(kMany));
    EXPECT_NEAR(product(e, e, 1) / product(e, e), 0, 5 / std::sqrt(kMany));
  }
}

TEST(SynthNoise, SensorsAreIndependent) {
  const Channels channels = noisy(alike(0.02));
  const std::vector<double> in = logs(channels[kInputTensionColumn]);
  const std::vector<double> out = logs(channels[kOutputTensionColumn]);
  EXPECT_NEAR(product(in, out) / 4e-4, 0, 5 / std::sqrt(kMany));
}

TEST(SynthNoise, AutocorrelationKeepsTheStandardDeviation) {
  const Channels channels = noisy(alike(0.02, 0.6));
  const std::vector<double> e = logs(channels[kOutputTensionColumn]);
  EXPECT_NEAR(std::sqrt(product(e, e)), 0.02, 0.0005);
  EXPECT_NEAR(product(e, e, 1) / product(e, e), 0.6, 0.03);
  EXPECT_NEAR(product(e, e, 2) / product(e, e), 0.36, 0.03);
}

TEST(SynthNoise, HeavyTailsAreThoseOfStudentsT) {
  const auto beyond = [](double dof) {
    const std::vector<double> e = logs(noisy(alike(0.02, 0, dof))[kOutputTensionColumn]);
    EXPECT_NEAR(std::sqrt(product(e, e)), 0.02, 0.001);
    return static_cast<double>(
               std::count_if(e.begin(), e.end(), [](double v) { return std::abs(v) > 0.08; })) /
           kMany;
  };
  // P(|t_5| > 4 sqrt(5/3)) = P(|t_5| > 5.164) = 0.0036; of a normal number beyond 4: 6.3e-5.
  EXPECT_NEAR(beyond(5), 0.0036, 5 * std::sqrt(0.0036 / kMany));
  EXPECT_LT(beyond(0), 0.0003);
}

// Readings are 1: r^2 + a^2 at each end.
TEST(SynthNoise, EachEndHasItsOwn) {
  const Channels channels = noisy(
      {.output = {.relative_sd = 0.003, .absolute_N = 0.004, .absolute_A = 9, .ar1 = 0.8},
       .input = {.relative_sd = 0.012, .absolute_N = 0.009, .absolute_A = 0.016, .ar1 = 0.3}});
  const auto expect = [&](hal::files::ProfileColumnId id, double sd, double ar1) {
    std::vector<double> e = channels[id];
    for (double& value : e) {
      value -= 1;
    }
    EXPECT_NEAR(std::sqrt(product(e, e)) / sd, 1, 0.03);
    EXPECT_NEAR(product(e, e, 1) / product(e, e), ar1, 0.03);
  };
  expect(kOutputTensionColumn, 0.005, 0.8);
  expect(kInputTensionColumn, 0.015, 0.3);
  expect(kMotorCurrentColumn, 0.020, 0.3);
}

// At a tension of 10 the absolute part stays, and the relative one is ten times as large.
TEST(SynthNoise, TheAbsolutePartDoesNotGrowWithTheReading) {
  const auto sd_at = [](double tension_N, const EndNoise& output) {
    Channels channels;
    channels[kOutputTensionColumn].assign(kMany, tension_N);
    add_noise({.output = output}, 1, 0, channels);
    double sum = 0;
    for (const double value : channels[kOutputTensionColumn]) {
      sum += (value - tension_N) * (value - tension_N);
    }
    return std::sqrt(sum / kMany);
  };
  EXPECT_NEAR(sd_at(10, {.absolute_N = 0.05}), 0.05, 0.001);
  EXPECT_NEAR(sd_at(10, {.relative_sd = 0.005}), 0.05, 0.001);
  EXPECT_NEAR(sd_at(0, {.absolute_N = 0.05}), 0.05, 0.001);
  EXPECT_NEAR(sd_at(0, {.relative_sd = 0.005}), 0, 1e-12);
}

TEST(SynthNoise, ReadingsComeInSteps) {
  const Channels channels = noisy({.output = {.relative_sd = 0.02},
                                   .input = {.relative_sd = 0.02},
                                   .tension_resolution_N = 0.05,
                                   .current_resolution_A = 0.25,
                                   .velocity_sd_m_s = 0.01,
                                   .velocity_resolution_m_s = 0.004});
  for (std::size_t i = 0; i < kMany; ++i) {
    ASSERT_NEAR(std::remainder(channels[kOutputTensionColumn][i], 0.05), 0, 1e-12);
    ASSERT_NEAR(std::remainder(channels[kInputTensionColumn][i], 0.05), 0, 1e-12);
    ASSERT_EQ(channels[kMotorCurrentColumn][i], 1.0);
    ASSERT_NEAR(std::remainder(channels[kTendonVelocity][i], 0.004), 0, 1e-12);
  }
  EXPECT_EQ(quantised(0.37, 0.25), 0.25);
  EXPECT_EQ(quantised(0.38, 0.25), 0.5);
  EXPECT_EQ(quantised(0.37, 0), 0.37);
}

TEST(SynthNoise, TimeJittersAndDriftsButNeverRunsBack) {
  for (const double drift_ppm : {500, -100'000}) {
    const Channels channels = noisy({.clock_jitter_s = 0.0016, .clock_drift_ppm = drift_ppm});
    const auto& time_s = channels[kTime];
    const double step_s = (1 + drift_ppm * 1e-6) / 200;
    double sum = 0;
    for (std::size_t i = 0; i < kMany; ++i) {
      const double jitter_s = time_s[i] - static_cast<double>(i) * step_s;
      sum += jitter_s * jitter_s;
      ASSERT_LE(std::abs(jitter_s), 0.45 * step_s + 1e-9);
      ASSERT_TRUE(i == 0 || time_s[i] > time_s[i - 1]);
    }
    // Clipped at 1.41 or 1.27 sd, which leaves 0.738 or 0.670 of the variance.
    EXPECT_NEAR(std::sqrt(sum / kMany), 0.0016 * std::sqrt(drift_ppm > 0 ? 0.738 : 0.670), 0.00003);
  }
}

TEST(SynthJitter, HasTheStandardDeviationAskedForAtEachEndOnItsOwn) {
  const Instants instants = draw_instants({.jitter_s = 0.0004}, 1, 0, kMany, 200);
  const double tolerance = 5 * 0.0004 / std::sqrt(2.0 * kMany);
  EXPECT_NEAR(std::sqrt(product(instants.output_s, instants.output_s)), 0.0004, tolerance);
  EXPECT_NEAR(std::sqrt(product(instants.input_s, instants.input_s)), 0.0004, tolerance);
  EXPECT_NEAR(product(instants.output_s, instants.input_s) / 1.6e-7, 0, 5 / std::sqrt(kMany));
  EXPECT_TRUE(draw_instants({}, 1, 0, kMany, 200).output_s.empty());
}

// The load is 30 - 10 cos(pi t), and the input the same at its own instant by exp(mu phi s), which
// no sample next to a reversal can be held to. The simulation goes by 0.25 ms.
TEST(SynthJitter, ReadsEachEndAtItsOwnInstant) {
  const std::string text = kRecordings + "[noise]\njitter_s = 0.001\n";
  const Channels channels = session(text);
  const Instants instants = draw_instants({.jitter_s = 0.001}, 1, 0, 800, 200);
  const auto load_N = [](double time_s) { return 30 - 10 * std::cos(kRate_rad_s * time_s); };
  const std::vector<double> s = directions(channels);
  for (std::size_t i = 0; i < 800; ++i) {
    const double output_s = std::max(0.0, time_of(i) + instants.output_s[i]);
    ASSERT_NEAR(channels[kOutputTensionColumn][i], load_N(output_s), 1e-5) << i;
    ASSERT_EQ(channels[kTime][i], time_of(i));
    if (i > 0 && i + 1 < 800 && s[i - 1] == s[i + 1]) {
      const double input_N = load_N(time_of(i) + instants.input_s[i]) * std::exp(kFull * s[i]);
      ASSERT_NEAR(channels[kInputTensionColumn][i], input_N, 1e-5) << i;
    }
  }
}

TEST(SynthNoise, DependsOnSeedAndSessionAlone) {
  const Noise noise = alike(0.02);
  EXPECT_EQ(noisy(noise, 3, 5), noisy(noise, 3, 5));
  EXPECT_NE(noisy(noise, 3, 5), noisy(noise, 4, 5));
  EXPECT_NE(noisy(noise, 3, 5), noisy(noise, 3, 6));
}

TEST(SynthScatter, IsThatOfSessions) {
  const SynthPlan plan =
      plan_of(kRecordings + "[scatter]\nlog_gain_sd = 0.01\nfriction_sd = 0.006\n");
  constexpr std::size_t kSessions = 4000;
  double gain = 0;
  double friction = 0;
  double both = 0;
  for (std::size_t i = 0; i < kSessions; ++i) {
    const SessionScatter scatter = session_scatter(plan, 1, i);
    gain += scatter.log_gain * scatter.log_gain;
    friction += scatter.friction * scatter.friction;
    both += scatter.log_gain * scatter.friction;
  }
  const double tolerance = 5 / std::sqrt(2.0 * kSessions);
  EXPECT_NEAR(std::sqrt(gain / kSessions) / 0.01, 1, tolerance);
  EXPECT_NEAR(std::sqrt(friction / kSessions) / 0.006, 1, tolerance);
  EXPECT_NEAR(both / kSessions / (0.01 * 0.006), 0, 5 / std::sqrt(kSessions));
}

TEST(SynthScatter, GainIsThatOfTheOutputAndFrictionIsAddedToMu) {
  const std::string text = kRecordings + "[scatter]\nlog_gain_sd = 0.05\nfriction_sd = 0.01\n";
  const SessionScatter scatter = session_scatter(plan_of(text), 1, 0);
  EXPECT_NE(scatter.log_gain, 0);
  expect_residuals(session(text), 1e-12, [&](std::size_t, double s) {
    return scatter.log_gain - scatter.friction * kPhi_rad * s;
  });
}

TEST(SynthSession, RefusesReadingsThatRunAway) {
  const std::string found = complaint_of([] {
    session(kRecordings +
            "[thermal]\nsheath_K_per_W = 10000\nsheath_time_constant_s = 0.01\n"
            "[effects.friction_temperature]\nslope_1_K = 0.02\n");
  });
  EXPECT_EQ(found.rfind("plan: in session 1, ", 0), 0U) << found;
}

}  // namespace

}  // namespace host_sim::synth::test
