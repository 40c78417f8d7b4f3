#include "host_sim/diagnose/force_records.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace host_sim::diagnose {
namespace {

using enum hal::files::ProfileColumnId;
using recording::Recording;

constexpr double kStep_s = 0.01;
constexpr double kNoise_N = 0.5;

NominalModel plain_sheath() {
  NominalModel model;
  model.sheath = {.friction_coefficient = 0.1, .bend_angle_deg = 180};
  return model;
}

/// Six seconds of a stroke of 40 mm at 0.5 Hz.
Recording recorded(double (*output_N)(double time_s), double start_cycle = 0) {
  std::mt19937 engine(5);
  std::normal_distribution<double> noise(0, kNoise_N);
  Recording recording;
  recording.session = "s";
  recording.start_cycle = start_cycle;
  for (int i = 0; i < 600; ++i) {
    const double time_s = kStep_s * i;
    recording.channels[kTime].push_back(time_s);
    recording.channels[kTendonVelocity].push_back(0.02 * std::numbers::pi *
                                                  std::cos(std::numbers::pi * time_s));
    recording.channels[kOutputTensionColumn].push_back(output_N(time_s) + noise(engine));
    recording.channels[kInputTensionColumn].push_back(20);
  }
  return recording;
}

double sine_N(double time_s) {
  return 30 + 10 * std::sin(2 * time_s);
}

effects::ForceRecord record_of(const Recording& recording) {
  return force_records({recording}, {}, plain_sheath(), false).at(0);
}

TEST(ForceRecords, SamplesAtRestDoNotCount) {
  Recording recording = recorded(sine_N);
  EXPECT_TRUE(record_of(recording).used[25]);
  recording.channels[kTendonVelocity][25] = 0;
  EXPECT_FALSE(record_of(recording).used[25]);
  EXPECT_TRUE(record_of(recording).measured[25]);
}

std::vector<double> noisy(std::vector<double> values, double sd) {
  std::mt19937 engine(3);
  std::normal_distribution<double> noise(0, sd);
  for (double& value : values) {
    value += noise(engine);
  }
  return values;
}

/// Two seconds there, two of rest and two back.
Recording there_and_back(std::vector<double> (*read)(std::vector<double> velocity_m_s)) {
  Recording recording = recorded(sine_N);
  std::vector<double> velocity_m_s(600);
  std::fill_n(velocity_m_s.begin(), 200, 0.02);
  std::fill_n(velocity_m_s.begin() + 400, 200, -0.02);
  recording.channels[kTendonVelocity] = read(velocity_m_s);
  return recording;
}

/// The tendon stays where it is at rest, and neither that counts nor the samples on either side.
void expect_rest(const effects::ForceRecord& record) {
  EXPECT_EQ(record.position_m[399], record.position_m[201]);
  EXPECT_EQ(std::ranges::count(record.used, false), 202);
  EXPECT_TRUE(record.used[198]);
  EXPECT_FALSE(record.used[199]);
  EXPECT_FALSE(record.used[400]);
  EXPECT_TRUE(record.used[401]);
}

TEST(ForceRecords, NoiseOfAVelocityAtRestIsNoMotion) {
  expect_rest(record_of(
      there_and_back([](std::vector<double> velocity_m_s) { return noisy(velocity_m_s, 0.001); })));
}

/// It flickers by a step of 0.5 mm/s in one sample of six, up and down, and moves in steps of that.
TEST(ForceRecords, StepsOfAVelocityAtRestAreNoMotion) {
  expect_rest(record_of(there_and_back([](std::vector<double> velocity_m_s) {
    for (std::size_t i = 0; i < velocity_m_s.size(); ++i) {
      const bool rests = velocity_m_s[i] == 0;
      const double flicker = i % 6 != 1 ? 0 : i % 12 == 1 ? 1 : -1;
      const double moves = static_cast<double>(i * 7 % 5) - 2;
      velocity_m_s[i] += 5e-4 * (rests ? flicker : moves);
    }
    return velocity_m_s;
  })));
}

/// Twelve samples of each of six turns are within four standard deviations of the noise: they are
/// taken for motion, but for those nearest to each turn, and some by chance.
TEST(ForceRecords, AMotionThatTurnsSlowlyDoesNotRest) {
  Recording recording = recorded(sine_N);
  recording.channels[kTendonVelocity] = noisy(recording.channels[kTendonVelocity], 0.003);
  EXPECT_LT(std::ranges::count(record_of(recording).used, false), 6 * 3 + 12);
}

TEST(ForceRecords, CyclesGoOnFromTheStartOfTheSession) {
  const std::vector<Recording> recordings{recorded(sine_N, 1000), recorded(sine_N, 3000)};
  const std::vector<effects::ForceRecord> records =
      force_records(recordings, {}, plain_sheath(), false);
  // Six reversals in six seconds, a cycle and a half before the middle; three of 2,000 are short.
  EXPECT_NEAR(records[1].cycle.front(), 3001.5, 0.05);
  EXPECT_EQ(records[1].cycle.back(), records[1].cycle.front());
  const std::vector<effects::ForceRecord> long_ones =
      force_records({recorded(sine_N, 0), recorded(sine_N, 20)}, {}, plain_sheath(), false);
  EXPECT_EQ(long_ones[1].cycle.front(), 20);
  EXPECT_EQ(long_ones[1].cycle.back(), 23);
  // One start alone does not say where in the life of the tendon it was.
  EXPECT_TRUE(record_of(recordings[0]).cycle.empty());
}

/// Two recordings at 20 and 22 C: what hardly varies shows nothing; 40 K do.
TEST(ForceRecords, ATemperatureCountsWhereItVaries) {
  std::vector<Recording> recordings{recorded(sine_N), recorded(sine_N)};
  for (const double warm_C : {22.0, 60.0}) {
    recordings[0].channels[kWindingTemperature].assign(600, 20);
    recordings[1].channels[kWindingTemperature].assign(600, warm_C);
    const std::vector<effects::ForceRecord> records =
        force_records(recordings, {}, plain_sheath(), false);
    EXPECT_EQ(records[1].winding_temperature_C.empty(), warm_C == 22);
    EXPECT_TRUE(records[1].sheath_temperature_C.empty());
  }
}

/// The load cell is read at every fifth of 600 samples: 119 are new after the first.
TEST(ForceRecords, AForceThatIsHeldCountsWhereItIsNew) {
  Recording recording = recorded(sine_N);
  std::vector<double>& output_N = recording.channels[kOutputTensionColumn];
  for (std::size_t i = 0; i < output_N.size(); ++i) {
    output_N[i] = output_N[i - i % 5];
  }
  const effects::ForceRecord record = record_of(recording);
  EXPECT_EQ(record.output_hold, 5);
  EXPECT_EQ(record.input_hold, 1);
  ASSERT_EQ(record.samples(), 119);
  EXPECT_DOUBLE_EQ(record.time_s[0], 5 * kStep_s);
  EXPECT_EQ(record.output_N[1], output_N[10]);
  EXPECT_EQ(record.velocity_m_s[1], recording.channels[kTendonVelocity][10]);
  EXPECT_NEAR(record.output_rate_N_s[60], 20 * std::cos(2 * record.time_s[60]), 6);
  // It turns over at 0.5 s and at 1.5 s, which are samples.
  EXPECT_EQ(record.reversal_m, record.position_m);
}

TEST(ForceRecords, TheRotorIsKnownWithoutADriveToo) {
  Recording recording = recorded(sine_N);
  EXPECT_TRUE(record_of(recording).rotor_rad.empty());
  recording.channels[kMotorAngle].assign(600, 1.5);
  EXPECT_EQ(record_of(recording).rotor_rad.at(7), 1.5);
  EXPECT_FALSE(record_of(recording).rotor_known);
}

TEST(ForceRecords, AreOfOneTendonWhereTheyAreSaidToBe) {
  EXPECT_FALSE(record_of(recorded(sine_N)).pulls_alone);
  EXPECT_TRUE(force_records({recorded(sine_N)}, {}, plain_sheath(), true).at(0).pulls_alone);
}

}  // namespace
}  // namespace host_sim::diagnose
