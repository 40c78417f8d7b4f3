#include <algorithm>

#include "host_sim/synth/tension/departures.hpp"
#include "tests/synth/support.hpp"

namespace host_sim::synth::test {

using hal::files::kBendAngle;
using hal::files::kInputTensionColumn;
using hal::files::kMotorAngle;
using hal::files::kMotorCurrentColumn;
using hal::files::kOutputTensionColumn;
using hal::files::kSheathTemperature;
using hal::files::kWindingTemperature;

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

}  // namespace

}  // namespace host_sim::synth::test
