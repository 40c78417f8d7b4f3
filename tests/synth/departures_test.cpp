#include "host_sim/synth/tension/departures.hpp"

#include <algorithm>

#include "tests/synth/support.hpp"

namespace host_sim::synth::test {

using enum hal::files::ProfileColumnId;

namespace {

/// Motor current by the nominal drive.
double nominal_A(double tension_N) {
  return tension_N * 0.0125 / (9 * 0.88 * 0.0325);
}

TEST(SynthDrive, TheCurrentSensorIsOff) {
  const Channels channels = session(kRecordings + "[effects.current_offset]\noffset_A = 0.05\n");
  for (std::size_t i = 0; i < 800; ++i) {
    ASSERT_NEAR(channels[kMotorCurrentColumn][i],
                nominal_A(channels[kInputTensionColumn][i]) + 0.05, 1e-12);
  }
}

TEST(SynthDrive, TheTorqueConstantDroopsWithTheWinding) {
  const Channels channels =
      session(kRecordings +
              "winding_starts_C = 90\n[effects.torque_gain]\nerror = 0.01\ndroop_1_K = 0.001\n");
  for (std::size_t i = 0; i < 800; ++i) {
    const double gain = 1 + 0.01 - 0.001 * (channels[kWindingTemperature][i] - 20);
    ASSERT_NEAR(channels[kMotorCurrentColumn][i],
                nominal_A(channels[kInputTensionColumn][i]) / gain, 1e-12);
  }
  EXPECT_GT(channels[kWindingTemperature].front(), channels[kWindingTemperature].back() + 5);
}

TEST(SynthDrive, TheWindingWarmsUntilItLosesWhatItGets) {
  const Channels channels = session(
      "[recordings]\nbend_angles_deg = 0\noutput_means_N = 40\noutput_amplitudes_N = 0\n"
      "frequencies_Hz = 1\ntravels_mm = 10\nsample_rate_Hz = 100\nduration_s = 3\n"
      "[thermal]\nwinding_time_constant_s = 0.1\nwinding_K_per_W = 6\n"
      "winding_resistance_ohm = 1.5\n");
  // dT = R_th I^2 R (1 + 0.00393 dT), I = 1.9425 A.
  const double cold_K = 6 * 1.5 * nominal_A(40) * nominal_A(40);
  EXPECT_NEAR(nominal_A(40), 1.9425, 1e-4);
  EXPECT_NEAR(channels[kWindingTemperature].back(), 20 + cold_K / (1 - 0.00393 * cold_K), 1e-3);
}

TEST(SynthDrive, FrictionHeatsTheSheath) {
  // Constant tension: power T (1 - e^-x) v or T (e^x - 1) v; with a long time constant the
  // temperature gathers the mean of the two, over 4 s of 80 mm a cycle.
  const Channels channels = session(
      "[recordings]\nbend_angles_deg = 270\noutput_means_N = 40\noutput_amplitudes_N = 0\n"
      "frequencies_Hz = 0.5\ntravels_mm = 40\nsample_rate_Hz = 200\nduration_s = 4.005\n"
      "[thermal]\nsheath_time_constant_s = 1e5\nsheath_K_per_W = 1e4\n");
  const double work_J = 40 * 2 * std::sinh(kMu * kPhi_rad) * 0.04 * 2;
  EXPECT_NEAR(channels[kSheathTemperature].back() - 20, work_J * 1e4 / 1e5, 0.01 * work_J * 0.1);
}

TEST(SynthDrive, TheGearHasOneEfficiencyForEachDirection) {
  const Channels channels = session(kRecordings +
                                    "[effects.gear_asymmetry]\npulling_efficiency = 0.853\n"
                                    "releasing_efficiency = 0.89\n");
  const std::vector<double> s = directions(channels);
  for (std::size_t i = 0; i < 800; ++i) {
    const double efficiency = s[i] > 0 ? 0.853 : 0.89;
    ASSERT_NEAR(channels[kMotorCurrentColumn][i],
                nominal_A(channels[kInputTensionColumn][i]) * 0.88 / efficiency, 1e-12);
  }
}

TEST(SynthDrive, CoggingGoesWithTheRotor) {
  const Channels channels =
      session(kRecordings +
              "[effects.torque_ripple]\namplitude_Nm = 0.001\nperiods_per_turn = 7\n"
              "phase_deg = 30\n");
  for (std::size_t i = 0; i < 800; ++i) {
    const double cogging_Nm = 0.001 * std::sin(7 * channels[kMotorAngle][i] + std::numbers::pi / 6);
    ASSERT_NEAR(channels[kMotorCurrentColumn][i],
                nominal_A(channels[kInputTensionColumn][i]) + cogging_Nm / 0.0325, 1e-11);
  }
}

TEST(SynthDrive, EachPoseHasItsOwnBend) {
  const std::string text =
      "[recordings]\nbend_angles_deg = [90, 270]\noutput_means_N = 30\noutput_amplitudes_N = 10\n"
      "frequencies_Hz = 0.5\ntravels_mm = 40\nsample_rate_Hz = 200\nduration_s = 4\n"
      "[effects.bend_angle]\nerror_deg = [12, -8]\n";
  const Channels channels = session(text, 1);
  expect_residuals(channels, 1e-12,
                   [](std::size_t, double s) { return kMu * 8 * std::numbers::pi / 180 * s; });
  EXPECT_NEAR(channels[kBendAngle][0], 270, 1e-12);
}

TEST(SynthSensors, ALagTurnsASineAndWeakensIt) {
  const Channels channels = session(kRecordings + "[effects.filter_lag]\ntime_constant_ms = 50\n");
  const double wt = kRate_rad_s * 0.05;
  for (std::size_t i = 200; i < 800; ++i) {
    const double t = static_cast<double>(i) / 200;
    const double expected =
        30 - 10 * std::cos(kRate_rad_s * t - std::atan(wt)) / std::sqrt(1 + wt * wt);
    ASSERT_NEAR(channels[kOutputTensionColumn][i], expected, 1e-6) << i;
  }
}

TEST(SynthSensors, ALagMayBeThatOfAnotherSensor) {
  const std::string lag = "[effects.filter_lag]\ntime_constant_ms = 50\nsensor = ";
  const Channels none = session(kRecordings);
  const Channels input = session(kRecordings + lag + "\"input_tension\"\n");
  const Channels current = session(kRecordings + lag + "\"motor_current\"\n");
  EXPECT_EQ(input[kOutputTensionColumn], none[kOutputTensionColumn]);
  EXPECT_EQ(input[kMotorCurrentColumn], none[kMotorCurrentColumn]);
  EXPECT_EQ(current[kInputTensionColumn], none[kInputTensionColumn]);
  EXPECT_NE(input[kInputTensionColumn][300], none[kInputTensionColumn][300]);
  EXPECT_NE(current[kMotorCurrentColumn][300], none[kMotorCurrentColumn][300]);
}

std::vector<double> undersampled(std::string_view between) {
  Values values;
  values.set("rate_Hz", {25});
  values.choose("between", between);
  for (const TensionKind& kind : tension_kinds()) {
    if (kind.id == "undersampling") {
      std::vector<double> readings{0, 1, 4, 9, 16, 25, 36, 49, 64, 81};
      kind.make(values)->record(Sensor::input_tension, readings, 100);
      return readings;
    }
  }
  return {};
}

TEST(SynthSensors, BetweenItsReadingsASlowDriveDrawsALine) {
  EXPECT_EQ(undersampled("line"), (std::vector<double>{0, 4, 8, 12, 16, 28, 40, 52, 64, 64}))
      << "but for the end, where the last reading stands";
}

TEST(SynthSensors, OrRepeatsTheLastOne) {
  EXPECT_EQ(undersampled("hold"), (std::vector<double>{0, 0, 0, 0, 16, 16, 16, 16, 64, 64}));
}

TEST(SynthSensors, PeaksAreLostBetweenReadings) {
  // Ten readings a cycle: a peak half-way between two of them loses 1 - cos(pi / 10).
  std::vector<double> readings;
  for (int i = 0; i < 2000; ++i) {
    readings.push_back(std::cos(2 * std::numbers::pi * (i + 10) / 200.0));
  }
  Values values;
  values.set("rate_Hz", {10});
  values.choose("between", "line");
  const auto kinds = tension_kinds();
  const auto kind = std::find_if(kinds.begin(), kinds.end(), [](const TensionKind& candidate) {
    return candidate.id == "undersampling";
  });
  kind->make(values)->record(Sensor::input_tension, readings, 200);
  const double peak = *std::max_element(readings.begin(), readings.end() - 20);
  EXPECT_NEAR(peak, std::cos(std::numbers::pi / 10), 1e-12);
}

double position_m(std::size_t i) {
  return -kStroke_m * std::cos(kRate_rad_s * time_of(i));
}

TEST(SynthFriction, WearGrowsWithAPowerOfTheCycles) {
  const Channels channels = session(kRecordings +
                                    "start_cycles = 400\n[effects.friction_wear]\nchange = 0.3\n"
                                    "reference_cycles = 100\nexponent = 0.5\n");
  expect_residuals(channels, 1e-12, [](std::size_t i, double s) {
    return -kFull * s * 0.3 * std::sqrt((400 + 0.5 * time_of(i)) / 100);
  });
}

TEST(SynthFriction, RunInFades) {
  const Channels channels =
      session(kRecordings +
              "start_cycles = 100\n[effects.friction_wear]\nlaw = \"run_in\"\nchange = 0.5\n"
              "reference_cycles = 100\n");
  expect_residuals(channels, 1e-12, [](std::size_t i, double s) {
    return -kFull * s * 0.5 * std::exp(-(100 + 0.5 * time_of(i)) / 100);
  });
}

TEST(SynthFriction, TemperatureFollowsItsSurroundings) {
  const Channels channels = session(kRecordings +
                                    "sheath_ambients_C = 60\n[thermal]\nsheath_time_constant_s = "
                                    "2\n[effects.friction_temperature]\nslope_1_K = 0.004\n");
  const auto warmer_K = [](std::size_t i) { return 40 * (1 - std::exp(-time_of(i) / 2)); };
  expect_residuals(channels, 1e-10,
                   [&](std::size_t i, double s) { return -kFull * s * 0.004 * warmer_K(i); });
  EXPECT_NEAR(channels[kSheathTemperature][400], 20 + 40 * (1 - std::exp(-1)), 1e-9);
}

TEST(SynthFriction, StribeckAndViscousFrictionGoWithTheSpeed) {
  const Channels channels = session(kRecordings +
                                    "[effects.friction_velocity]\nstatic_coefficient = 0.2\n"
                                    "stribeck_velocity_mm_s = 10\nviscous_s_m = 0.5\n");
  expect_residuals(channels, 1e-12, [](std::size_t i, double s) {
    const double speed = std::abs(kStroke_m * kRate_rad_s * std::sin(kRate_rad_s * time_of(i)));
    return -s * kPhi_rad * ((0.2 - kMu) * std::exp(-speed / 0.01) + 0.5 * speed);
  });
}

TEST(SynthFriction, PreslidingGrowsWithTheTravelSinceAReversal) {
  const Channels channels = session(kRecordings + "[effects.presliding]\nlength_mm = 2\n");
  // The first reversal is the start, after letting go; dz/dx = (1 - z s) / x0.
  expect_residuals(channels, 1e-8, [](std::size_t i, double s) {
    const double from_m = s > 0 ? -kStroke_m : kStroke_m;
    const double z = s * (1 - 2 * std::exp(-std::abs(position_m(i) - from_m) / 0.002));
    return kFull * (s - z);
  });
}

TEST(SynthFriction, LoadDependenceIsIntegratedAlongTheSheath) {
  const Channels channels =
      session(kRecordings + "[effects.friction_load]\nexponent = 0.3\nreference_N = 25\n");
  // dT/dphi = mu T0^k T^(1-k) s: T^k grows linearly along the angle.
  for (std::size_t i = 1; i < 800; ++i) {
    const double s = channels[kTendonVelocity][i] > 0 ? 1 : -1;
    if (std::abs(channels[kTendonVelocity][i]) < 1e-9) {
      continue;
    }
    const double power =
        std::pow(channels[kOutputTensionColumn][i], 0.3) + 0.3 * kFull * std::pow(25, 0.3) * s;
    ASSERT_NEAR(channels[kInputTensionColumn][i], std::pow(power, 1 / 0.3), 1e-3) << i;
  }
}

TEST(SynthFriction, NoLoadDependenceIsTheCapstanLaw) {
  const Channels channels =
      session(kRecordings + "[effects.friction_load]\nexponent = 0\nreference_N = 25\n");
  expect_residuals(channels, 1e-12, [](std::size_t, double) { return 0.0; });
}

TEST(SynthFriction, PreloadIsAForceAgainstTheMotion) {
  const Channels with = session(kRecordings + "[effects.friction_preload]\nforce_N = 3\n");
  const Channels without = session(kRecordings);
  const std::vector<double> s = directions(with);
  for (std::size_t i = 0; i < s.size(); ++i) {
    ASSERT_NEAR(with[kInputTensionColumn][i] - without[kInputTensionColumn][i], 3 * s[i], 1e-11);
  }
}

TEST(SynthFriction, ATendonDoesNotPush) {
  const Channels channels = session(kRecordings + "[effects.friction_preload]\nforce_N = 20\n");
  EXPECT_EQ(
      *std::min_element(channels[kInputTensionColumn].begin(), channels[kInputTensionColumn].end()),
      0.0);
}

TEST(SynthFriction, ATightPlaceIsPassedAtItsPosition) {
  const Channels channels = session(
      kRecordings + "[effects.friction_position]\nchange = 0.4\ncentre_mm = 5\nwidth_mm = 3\n");
  expect_residuals(channels, 1e-12, [](std::size_t i, double s) {
    const double from = (position_m(i) - 0.005) / 0.003;
    return -kFull * s * 0.4 * std::exp(-from * from / 2);
  });
}

TEST(SynthFriction, SlackIsTakenUpAfterEachReversal) {
  const Channels channels =
      session(kRecordings + "[effects.slack]\ndead_zone_mm = 1.5\nheld_share = 0.8\n");
  std::size_t loose = 0;
  expect_residuals(channels, 1e-12, [&](std::size_t i, double s) {
    const double from_m = s > 0 ? -kStroke_m : kStroke_m;
    const double travel_m = std::abs(position_m(i) - from_m);
    const bool in_gap = travel_m > 1e-12 && travel_m < 0.0015;
    loose += in_gap ? 1 : 0;
    return in_gap ? -std::log(0.8) : 0.0;
  });
  // 1.5 mm of the cosine's first: acos(1 - 1.5 / 20) / pi s = 24.7 samples after each of 4.
  EXPECT_NEAR(static_cast<double>(loose), 4 * 24.7, 4);
}

TEST(SynthFriction, AStretchedTendonFollowsItsSpringUntilItSlides) {
  const Channels channels = session(kRecordings + "[effects.compliance]\nstiffness_N_mm = 4\n");
  const double low_N = 20 * std::exp(-kFull);
  bool slides = false;
  for (std::size_t i = 0; i < 200; ++i) {
    const double stretched_N = low_N + 4000 * (position_m(i) + kStroke_m);
    const double sliding_N = channels[kOutputTensionColumn][i] * std::exp(kFull);
    slides = slides || stretched_N > sliding_N;
    ASSERT_NEAR(channels[kInputTensionColumn][i], slides ? sliding_N : stretched_N, 1e-6) << i;
  }
  EXPECT_TRUE(slides);
}

TEST(SynthFriction, AStiffTendonIsTheCapstanLaw) {
  const Channels channels =
      session(kRecordings + "[effects.compliance]\nstiffness_N_mm = 100000\n");
  const std::vector<double> r = residuals(channels);
  for (std::size_t i = 0; i < r.size(); ++i) {
    if (i % 200 > 2) {
      ASSERT_NEAR(r[i], 0, 1e-9) << i;
    }
  }
}

TEST(SynthFriction, SpringAndPreslidingActInSeries) {
  const Channels channels =
      session(kRecordings +
              "[effects.compliance]\nstiffness_N_mm = 8\n[effects.presliding]\nlength_mm = 2\n");
  // Travel is stretch and slide; the slide gives the state, the state the tension.
  const double low_N = 20 * std::exp(-kFull);
  for (std::size_t i = 1; i < 200; ++i) {
    const double tension_N = channels[kInputTensionColumn][i];
    const double slide_m = position_m(i) + kStroke_m - (tension_N - low_N) / 8000;
    const double z = 1 - 2 * std::exp(-slide_m / 0.002);
    ASSERT_NEAR(tension_N, channels[kOutputTensionColumn][i] * std::exp(kFull * z), 0.02) << i;
  }
}

}  // namespace

}  // namespace host_sim::synth::test
