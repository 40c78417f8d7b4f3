#include "tests/synth/support.hpp"

namespace host_sim::synth::test {

using enum hal::files::ProfileColumnId;

namespace {

TEST(SynthOutside, CreepDriftsInTheCourseOfASession) {
  const Channels channels =
      session(kRecordings + "[outside.sheath_creep]\nshare = 0.05\ntime_constant_s = 3\n");
  expect_residuals(channels, 1e-12, [](std::size_t i, double) {
    return -std::log(1 + 0.05 * (1 - std::exp(-time_of(i) / 3)));
  });
}

TEST(SynthOutside, StickSlipComesInBursts) {
  const std::string text =
      "[recordings]\nbend_angles_deg = 270\noutput_means_N = 30\noutput_amplitudes_N = 10\n"
      "frequencies_Hz = 0.5\ntravels_mm = 40\nsample_rate_Hz = 100\nduration_s = 400\n"
      "[outside.stick_slip]\nshare = 0.5\nbursts_per_min = 30\nburst_s = 1\nfrequency_Hz = 7.3\n";
  const Channels channels = session(text);
  const std::vector<double> r = residuals(channels);
  const std::vector<double> s = directions(channels);
  double within = 0;
  for (std::size_t i = 0; i < r.size(); ++i) {
    const double more = -r[i] * s[i] / kFull;
    ASSERT_GE(more, -1e-12);
    ASSERT_LE(more, 0.5 + 1e-12);
    within += more > 1e-9 ? 1 : 0;
  }
  // A burst of 1 s after a wait of 2 s on average: one third, give or take 4 standard errors.
  EXPECT_NEAR(within / static_cast<double>(r.size()), 1.0 / 3, 0.1);
}

TEST(SynthOutside, TheLoadCellFeelsTheSwayOfThePose) {
  const std::string sway = "pose_sway_deg = 10\npose_sway_Hz = 0.4\n";
  const Channels without = session(kRecordings + sway);
  const Channels with =
      session(kRecordings + sway + "[outside.load_cell_cross_talk]\nsensitivity_N_s_rad = 2\n");
  const double rate = 2 * std::numbers::pi * 0.4;
  for (std::size_t i = 0; i < 800; ++i) {
    ASSERT_NEAR(with[kInputTensionColumn][i] - without[kInputTensionColumn][i],
                2 * std::numbers::pi / 18 * rate * std::cos(rate * time_of(i)), 1e-11);
    ASSERT_EQ(with[kMotorCurrentColumn][i], without[kMotorCurrentColumn][i]);
  }
}

TEST(SynthOutside, HumidityGoesByTheClockOnTheWall) {
  const std::string text = kRecordings +
                           "repeats = 4\nsession_interval_h = 3\n"
                           "[outside.humidity_cycle]\nshare = 0.2\n";
  // After 6 h of 24 h the sine is at its top.
  expect_residuals(session(text, 2), 1e-6, [](std::size_t, double s) { return -kFull * 0.2 * s; });
  const Channels first = session(text, 0);
  expect_residuals(first, 1e-12, [](std::size_t i, double s) {
    return -kFull * 0.2 * s * std::sin(2 * std::numbers::pi * time_of(i) / 3600 / 24);
  });
}

TEST(SynthOutside, ASheathStraightensWithTheTension) {
  const Channels channels = session(
      kRecordings + "[outside.tension_dependent_bend]\nshare_1_N = -0.01\nreference_N = 30\n");
  expect_residuals(channels, 1e-12, [&](std::size_t i, double s) {
    return kFull * s * 0.01 * (channels[kOutputTensionColumn][i] - 30);
  });
}

TEST(SynthOutside, TheLoadCellsZeroDriftsWithALag) {
  const std::string warm = "sheath_ambients_C = 50\n";
  const Channels without = session(kRecordings + warm);
  const Channels with =
      session(kRecordings + warm +
              "[outside.load_cell_thermal_lag]\ndrift_N_K = 0.02\ntime_constant_s = 5\n");
  for (std::size_t i = 0; i < 800; ++i) {
    ASSERT_NEAR(with[kInputTensionColumn][i] - without[kInputTensionColumn][i],
                0.02 * 30 * (1 - std::exp(-time_of(i) / 5)), 1e-9);
  }
}

TEST(SynthOutside, TheMotorTurnsItsRotorToo) {
  const Channels without = session(kRecordings);
  const Channels with = session(kRecordings + "[outside.rotor_inertia]\ninertia_g_cm2 = 50\n");
  for (std::size_t i = 0; i < 800; ++i) {
    const double acceleration =
        kStroke_m * kRate_rad_s * kRate_rad_s * std::cos(kRate_rad_s * time_of(i)) * 9 / 0.0125;
    ASSERT_NEAR(with[kMotorCurrentColumn][i] - without[kMotorCurrentColumn][i],
                50e-7 * acceleration / 0.0325, 1e-12);
  }
}

}  // namespace

}  // namespace host_sim::synth::test
