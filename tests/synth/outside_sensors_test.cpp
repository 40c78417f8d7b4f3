#include <algorithm>

#include "tests/synth/support.hpp"

namespace host_sim::synth::test {

using enum hal::files::ProfileColumnId;

namespace {

TEST(SynthOutside, FrictionGrowsWhileTheTendonSpeedsUp) {
  expect_residuals(session(kRecordings + "[outside.friction_acceleration]\nshare_s2_m = 2\n"), 1e-9,
                   [](std::size_t i, double s) {
                     const double acceleration_m_s2 =
                         kStroke_m * kRate_rad_s * kRate_rad_s * std::cos(kRate_rad_s * time_of(i));
                     return -kFull * s * 2 * acceleration_m_s2 * s;
                   });
}

// By many small steps of dc/dt = (1 - c) / 0.3 - c |v| / 0.002.
TEST(SynthOutside, RestBondsTheTendonToTheSheath) {
  constexpr int kStepsPerSample = 400;
  const double step_s = 1.0 / 200 / kStepsPerSample;
  std::vector<double> bond{1};
  for (int i = 1; i < 800; ++i) {
    double c = bond.back();
    for (int k = 0; k < kStepsPerSample; ++k) {
      const double time_s = (i - 1) / 200.0 + (k + 0.5) * step_s;
      const double speed_m_s = kStroke_m * kRate_rad_s * std::abs(std::sin(kRate_rad_s * time_s));
      c += step_s * ((1 - c) / 0.3 - c * speed_m_s / 0.002);
    }
    bond.push_back(c);
  }
  EXPECT_LT(*std::min_element(bond.begin(), bond.end()), 0.15);
  expect_residuals(
      session(kRecordings +
              "[outside.dwell_friction]\nshare = 0.5\ntime_constant_s = 0.3\nlength_mm = 2\n"),
      1e-3, [&](std::size_t i, double s) { return -kFull * s * 0.5 * bond[i]; });
}

TEST(SynthOutside, TheGainDriftsInEachSessionAtAnotherRate) {
  const std::string text =
      kRecordings + "repeats = 300\n[outside.gain_drift]\nlog_per_min_sd = 0.6\n";
  const SynthPlan plan = plan_of(text);
  double sum = 0;
  for (const Setting& setting : settings_of(*plan.recordings, 1)) {
    const std::vector<double> r = residuals(session_channels(plan, setting, {}, 1));
    const double log_per_s = r[400] / 2;
    ASSERT_NEAR(r[799], log_per_s * 799 / 200, 1e-9);
    sum += log_per_s * log_per_s;
  }
  // 0.01 a second; of 300 normal numbers, 4 standard errors.
  EXPECT_NEAR(std::sqrt(sum / 300), 0.01, 4 * 0.01 / std::sqrt(600.0));
}

// Eight plays of half widths 0.5 .. 4 N: after a turn by 2 N those of up to 1 N, two of them, have
// turned; the others stand where they were.
TEST(SynthOutside, TheLoadCellRemembersItsWay) {
  const Channels without = session(kRecordings);
  const Channels with =
      session(kRecordings + "[outside.load_cell_hysteresis]\nshare = 0.4\nwidest_N = 8\n");
  double plays_N[8];
  std::fill(std::begin(plays_N), std::end(plays_N), without[kInputTensionColumn][0]);
  double most_N = 0;
  for (std::size_t i = 0; i < 800; ++i) {
    const double value = without[kInputTensionColumn][i];
    double expected_N = 0.6 * value;
    for (int k = 0; k < 8; ++k) {
      const double half_N = 0.5 * (k + 1);
      plays_N[k] = std::max(value - half_N, std::min(value + half_N, plays_N[k]));
      expected_N += 0.05 * plays_N[k];
    }
    ASSERT_NEAR(with[kInputTensionColumn][i], expected_N, 2e-3) << i;
    most_N = std::max(most_N, std::abs(value - with[kInputTensionColumn][i]));
    ASSERT_EQ(with[kMotorCurrentColumn][i], without[kMotorCurrentColumn][i]);
  }
  // All behind by their half widths, 2.25 N in the mean.
  EXPECT_NEAR(most_N, 0.4 * 2.25, 1e-3);
}

// After a step by D at a reversal, D exp(-zeta w t) cos(w t) about what is measured, nearly.
TEST(SynthOutside, TheSensorsAtTheDriveRing) {
  const Channels without = session(kRecordings);
  const Channels with =
      session(kRecordings + "[outside.resonance]\nfrequency_Hz = 10\ndamping = 0.05\n");
  const double rate_rad_s = 2 * std::numbers::pi * 10;
  const auto ringing = [&](hal::files::ProfileColumnId id, std::size_t i) {
    return with[id][i] - without[id][i];
  };
  // The first reversal is at 1 s: from exp(mu phi) to exp(-mu phi) times 40 N.
  const double step_N = 40 * 2 * std::sinh(kFull);
  for (std::size_t i = 202; i < 240; ++i) {
    const double since_s = time_of(i) - 1;
    const double expected_N =
        step_N * std::exp(-0.05 * rate_rad_s * since_s) * std::cos(rate_rad_s * since_s);
    ASSERT_NEAR(ringing(kInputTensionColumn, i), expected_N, 0.1 * step_N) << i;
    ASSERT_NEAR(current_tension_N(ringing(kMotorCurrentColumn, i)), ringing(kInputTensionColumn, i),
                1e-6);
  }
  EXPECT_EQ(with[kOutputTensionColumn], without[kOutputTensionColumn]);
}

TEST(SynthOutside, TheOutputSaturatesSoftly) {
  const Channels channels = session(kRecordings + "[outside.soft_saturation]\nlimit_N = 80\n");
  for (std::size_t i = 0; i < 800; ++i) {
    const double true_N = 30 - 10 * std::cos(kRate_rad_s * time_of(i));
    ASSERT_NEAR(channels[kOutputTensionColumn][i], 80 * std::tanh(true_N / 80), 1e-9);
  }
}

TEST(SynthOutside, AVelocityInStepsFlickersAtStandstill) {
  const std::vector<double> exact = session(kRecordings)[kTendonVelocity];
  const std::vector<double> steps =
      session(kRecordings + "[outside.velocity_steps]\nstep_mm_s = 10\n")[kTendonVelocity];
  int still = 0;
  int wrong = 0;
  for (std::size_t i = 0; i < 800; ++i) {
    if (std::abs(exact[i]) < 0.005) {
      ASSERT_EQ(std::abs(steps[i]), 0.01);
      ++still;
      wrong += exact[i] * steps[i] < 0 ? 1 : 0;
    } else {
      ASSERT_NEAR(std::remainder(steps[i], 0.01), 0, 1e-12);
      ASSERT_GT(steps[i] * exact[i], 0);
    }
  }
  EXPECT_GT(still, 30);
  EXPECT_NEAR(static_cast<double>(wrong) / still, 0.5, 2 / std::sqrt(still));
}

}  // namespace

}  // namespace host_sim::synth::test
