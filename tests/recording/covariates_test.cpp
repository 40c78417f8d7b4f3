#include "host_sim/recording/covariates.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "tests/io/support.hpp"
#include "tests/recording/support.hpp"

namespace host_sim::recording {

using enum hal::files::ProfileColumnId;
using hal::files::ProfileColumnId;

namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Nine samples, one a second; the tendon turns at the third and at the seventh.
Recording by_hand() {
  Recording recording;
  recording.session = "s1";
  recording.file = "s1.csv";
  recording.start_cycle = 100;
  recording.channels[kTime] = {0, 1, 2, 3, 4, 5, 6, 7, 8};
  recording.channels[kTendonVelocity] = {1, 1, -1, -2, -2, -1, 1, 3, 1};
  recording.channels[kOutputTensionColumn] = {10, 11, 12, 13, 14, 15, 16, 17, 18};
  recording.channels[kInputTensionColumn] = {1, 2, 4, 8, 16, 32, 64, 128, 256};
  return recording;
}

NominalModel nominal() {
  NominalModel nominal;
  nominal.sheath = {.friction_coefficient = 0.128, .bend_angle_deg = 180};
  nominal.drive = {.torque_constant_Nm_per_A = 0.05,
                   .gear_ratio = 10,
                   .gear_efficiency = 0.8,
                   .spool_radius_mm = 20,
                   .current_offset_A = 0.5};
  return nominal;
}

TEST(Covariates, AreThoseCalculatedByHand) {
  const Covariates found = covariates_of(by_hand(), {}, nominal());
  // Neither before the first travel nor next to where the tendon turns.
  EXPECT_THAT(found.time_s, ElementsAre(3, 4, 7, 8));
  EXPECT_THAT(found.direction, ElementsAre(-1, -1, 1, 1));
  EXPECT_THAT(found.cycle, ElementsAre(100.5, 100.5, 101, 101));
  EXPECT_THAT(found.velocity_m_s, ElementsAre(-2, -2, 3, 1));
  EXPECT_THAT(found.travel_m, ElementsAre(1.75, 3.75, 2.25, 4.25));
  // The integral is 0, 1, 1, -0.5, -2.5, -4, -4, -2, 0, the middle of its range -1.5.
  EXPECT_THAT(found.position_m, ElementsAre(1, -1, -0.5, 1.5));
  EXPECT_THAT(found.input_tension_N, ElementsAre(8, 16, 128, 256));
  EXPECT_THAT(found.output_tension_N, ElementsAre(13, 14, 17, 18));
  EXPECT_THAT(found.bend_angle_rad, testing::Each(testing::DoubleEq(std::numbers::pi)));
  EXPECT_THAT(found.log_tension_rate_1_s, testing::Each(testing::DoubleEq(std::log(2.0))));
  EXPECT_THAT(
      found.log_output_rate_1_s,
      testing::Pointwise(testing::DoubleEq(),
                         std::vector<double>{std::log(15.0 / 11) / 4, std::log(16.0 / 12) / 4,
                                             std::log(1.2) / 3, std::log(18.0 / 16) / 2}));
  EXPECT_THAT(found.current_A, IsEmpty());
  EXPECT_THAT(found.motor_angle_rad, IsEmpty());
  EXPECT_EQ(&found.tension_in_N(), &found.input_tension_N);
}

TEST(Covariates, DifferTensionOverTwoSamplesToEachSideFewerAtTheEnds) {
  Recording recording = by_hand();
  recording.channels[kInputTensionColumn] = {1, 1, 1, 1, 1, 16, 1, 1, 4};
  const Covariates found = covariates_of(recording, {}, nominal());
  const double ln2 = std::log(2.0);
  EXPECT_THAT(
      found.log_tension_rate_1_s,
      testing::Pointwise(testing::DoubleEq(), std::vector<double>{ln2, 0, -2 * ln2 / 3, ln2}));
}

TEST(Covariates, GiveTheTensionThatACurrentStandsFor) {
  Recording recording = by_hand();
  recording.channels[kMotorCurrentColumn] = std::vector<double>(9, 1.5);
  recording.channels[kInputTensionColumn].clear();
  const Covariates found = covariates_of(recording, {}, nominal());
  // 0.05 Nm/A * (1.5 A - 0.5 A) * 10 * 0.8 / 0.02 m
  EXPECT_THAT(found.current_tension_N, testing::Each(testing::DoubleEq(20)));
  EXPECT_THAT(found.current_A, testing::Each(1.0));
  EXPECT_THAT(found.log_tension_rate_1_s, testing::Each(0.0));
  EXPECT_EQ(&found.tension_in_N(), &found.current_tension_N);
}

TEST(Covariates, TakePositionFromTheMotorAngle) {
  Recording recording = by_hand();
  recording.channels[kMotorAngle] = {0, 1, 2, 3, 4, 5, 6, 7, 8};
  const Covariates found = covariates_of(recording, {}, nominal());
  EXPECT_THAT(found.motor_angle_rad, ElementsAre(3, 4, 7, 8));
  EXPECT_DOUBLE_EQ(found.position_m.back(), 8 * 0.02 / 10);
  NominalModel no_drive = nominal();
  no_drive.drive.reset();
  EXPECT_DOUBLE_EQ(covariates_of(recording, {}, no_drive).position_m.back(), 1.5);
}

TEST(Covariates, TakeTheBendAngleOfTheRecordingWhereThereIsOne) {
  Recording recording = by_hand();
  recording.channels[kBendAngle] = std::vector<double>(9, 90);
  NominalModel no_sheath = nominal();
  no_sheath.sheath.reset();
  EXPECT_DOUBLE_EQ(covariates_of(recording, {}, no_sheath).bend_angle_rad.front(),
                   std::numbers::pi / 2);
}

TEST(Covariates, AreRefusedWithoutWhatTheyNeed) {
  Recording recording = by_hand();
  NominalModel none;
  EXPECT_EQ(test::complaint_of([&] { covariates_of(recording, {}, none); }),
            "s1.csv: session 's1' has no known bend angle; accepted: the column bend_angle_deg, or "
            "bend_angle_deg in [model.sheath] of campaign.toml");
  none.sheath = nominal().sheath;
  recording.channels[kMotorCurrentColumn] = std::vector<double>(9, 1.5);
  EXPECT_EQ(test::complaint_of([&] { covariates_of(recording, {}, none); }),
            "s1.csv: session 's1' has motor_current_A, but the campaign no drive; accepted: "
            "[model.drive] in campaign.toml");
}

Fault fault(ProfileColumnId channel, Fault::Kind kind, std::size_t first, std::size_t count) {
  return {"s1", channel, kind, first, count, ""};
}

TEST(Covariates, LeaveOutTheSamplesOfAFault) {
  Recording recording = test::recording_of({});
  const std::size_t whole = covariates_of(recording, {}, nominal()).samples();
  const Covariates found = covariates_of(
      recording, {fault(kOutputTensionColumn, Fault::Kind::stuck, 1000, 50)}, nominal());
  EXPECT_EQ(found.samples(), whole - 50);
  EXPECT_FALSE(testing::Matches(
      testing::Contains(testing::AllOf(testing::Ge(4.9999), testing::Lt(5.2499))))(found.time_s));
  Fault other = fault(kOutputTensionColumn, Fault::Kind::stuck, 1000, 50);
  other.session = "s2";
  EXPECT_EQ(covariates_of(recording, {other}, nominal()).samples(), whole);
}

TEST(Covariates, CountAConstantChannelAsNotRecorded) {
  const Recording recording = test::recording_of({});
  const auto without = [&](ProfileColumnId channel) {
    return covariates_of(recording, {fault(channel, Fault::Kind::constant, 0, 4000)}, nominal());
  };
  EXPECT_THAT(without(kInputTensionColumn).input_tension_N, IsEmpty());
  EXPECT_GT(without(kInputTensionColumn).samples(), 3000U);
  EXPECT_THAT(without(kMotorAngle).motor_angle_rad, IsEmpty());
  EXPECT_GT(without(kMotorAngle).position_m.size(), 3000U);
  EXPECT_EQ(without(kOutputTensionColumn).samples(), 0U);
  EXPECT_EQ(without(kTendonVelocity).samples(), 0U);
}

TEST(Covariates, LeaveOutTensionsThatAreNotPositive) {
  Recording recording = test::recording_of({});
  const std::size_t whole = covariates_of(recording, {}, nominal()).samples();
  recording.channels[kOutputTensionColumn][2000] = 0;
  recording.channels[kMotorCurrentColumn][3000] = 0.5;  // its offset
  const Covariates found = covariates_of(recording, {}, nominal());
  EXPECT_EQ(found.samples(), whole - 2);
  EXPECT_TRUE(std::isfinite(found.log_tension_rate_1_s[1990]));
  EXPECT_TRUE(std::isfinite(found.log_output_rate_1_s[1990]));
}

TEST(Covariates, TakeUpDirectionAndTravelAnewBehindAGap) {
  Recording recording = test::recording_of({});
  for (auto& values : recording.channels) {
    values.erase(values.begin() + 1000, values.begin() + 1300);
  }
  const auto faults = faults_of({recording});
  ASSERT_EQ(faults.size(), 1U);
  const Covariates found = covariates_of(recording, faults, nominal());
  std::size_t behind = 0;
  while (found.time_s[behind] < 6) {
    ++behind;
  }
  EXPECT_LT(found.time_s[behind - 1], 5);
  EXPECT_GE(found.travel_m[behind], 0.005);
  EXPECT_LT(found.travel_m[behind], 0.0053);
}

TEST(Covariates, OfARecordingThatNeverMovesAreNone) {
  Recording recording = by_hand();
  recording.channels[kTendonVelocity] = std::vector<double>(9);
  EXPECT_EQ(covariates_of(recording, {}, nominal()).samples(), 0U);
}

TEST(Covariates, CountTheCyclesOfALongRecording) {
  for (const double frequency_Hz : {0.5, 2.0}) {
    for (const double noise : {0.0, 0.01}) {
      const Recording recording =
          test::recording_of({.frequency_Hz = frequency_Hz, .noise = noise});
      // The phase goes from 0.03 on: two reversals in each cycle.
      EXPECT_EQ(covariates_of(recording, {}, nominal()).cycle.back(), 20 * frequency_Hz)
          << frequency_Hz << ' ' << noise;
    }
  }
}

RC_GTEST_PROP(Covariates, MoveWithTime, ()) {
  const auto seconds = *rc::gen::inRange(-1000, 1000);
  Recording recording = by_hand();
  const Covariates found = covariates_of(recording, {}, nominal());
  for (double& time_s : recording.channels[kTime]) {
    time_s += seconds;
  }
  const Covariates later = covariates_of(recording, {}, nominal());
  RC_ASSERT(later.samples() == found.samples());
  for (std::size_t i = 0; i < found.samples(); ++i) {
    RC_ASSERT(later.time_s[i] == found.time_s[i] + seconds);
  }
  RC_ASSERT(later.travel_m == found.travel_m);
  RC_ASSERT(later.position_m == found.position_m);
  RC_ASSERT(later.cycle == found.cycle);
  RC_ASSERT(later.log_tension_rate_1_s == found.log_tension_rate_1_s);
  RC_ASSERT(later.log_output_rate_1_s == found.log_output_rate_1_s);
}

RC_GTEST_PROP(Covariates, ScaleWithTensionButTheirLogarithmicRate, ()) {
  const double factor = std::exp2(*rc::gen::inRange(-8, 8));
  Recording recording = by_hand();
  const Covariates found = covariates_of(recording, {}, nominal());
  for (const ProfileColumnId id : {kInputTensionColumn, kOutputTensionColumn}) {
    for (double& tension_N : recording.channels[id]) {
      tension_N *= factor;
    }
  }
  const Covariates larger = covariates_of(recording, {}, nominal());
  RC_ASSERT(larger.input_tension_N.back() == factor * found.input_tension_N.back());
  RC_ASSERT(larger.output_tension_N.front() == factor * found.output_tension_N.front());
  RC_ASSERT(larger.log_tension_rate_1_s == found.log_tension_rate_1_s);
  RC_ASSERT(larger.log_output_rate_1_s == found.log_output_rate_1_s);
  RC_ASSERT(larger.direction == found.direction);
}

RC_GTEST_PROP(Covariates, AreFiniteAndOfOneLength, ()) {
  Recording recording = by_hand();
  for (const ProfileColumnId id :
       {kInputTensionColumn, kMotorCurrentColumn, kOutputTensionColumn, kTendonVelocity}) {
    recording.channels[id].clear();
    for (int i = 0; i < 9; ++i) {
      recording.channels[id].push_back(*rc::gen::inRange(-1, 9));
    }
  }
  const Covariates found = covariates_of(recording, faults_of({recording}), nominal());
  for (const auto& values :
       {found.cycle, found.direction, found.velocity_m_s, found.output_tension_N, found.travel_m,
        found.position_m, found.log_tension_rate_1_s, found.log_output_rate_1_s,
        found.tension_in_N()}) {
    RC_ASSERT(values.size() == found.samples());
    for (const double value : values) {
      RC_ASSERT(std::isfinite(value));
    }
  }
  for (std::size_t i = 0; i < found.samples(); ++i) {
    RC_ASSERT(found.output_tension_N[i] > 0);
    RC_ASSERT(found.tension_in_N()[i] > 0);
    RC_ASSERT(i == 0 || found.cycle[i] >= found.cycle[i - 1]);
  }
}

/// Two strokes of 20 samples at 2 rad, of which the first `unsettled` each are just behind the turn
/// and have no friction at all.
Covariates strokes(double mu, std::size_t unsettled) {
  Covariates made;
  for (const double direction : {1.0, -1.0}) {
    for (std::size_t i = 0; i < 20; ++i) {
      const bool settled = i >= unsettled;
      made.time_s.push_back(static_cast<double>(made.samples()) * 0.01);
      made.direction.push_back(direction);
      made.bend_angle_rad.push_back(2);
      made.travel_m.push_back(settled ? 0.01 : 0.001);
      made.input_tension_N.push_back(40);
      made.output_tension_N.push_back(40 * std::exp(0.3 - (settled ? mu * 2 * direction : 0.0)));
    }
  }
  return made;
}

TEST(SettledFriction, IsThatOfTheSamplesFarFromReversals) {
  EXPECT_NEAR(settled_friction(strokes(0.12, 0)), 0.12, 1e-12);
  EXPECT_NEAR(settled_friction(strokes(0.12, 14)), 0.12, 1e-12);
}

TEST(SettledFriction, IsNotToldByTheEndsOfShortStrokes) {
  EXPECT_EQ(settled_friction(strokes(0.12, 16)), 0);
}

TEST(SettledFriction, IsNotToldByOneDirection) {
  Covariates one = strokes(0.12, 0);
  for (double& direction : one.direction) {
    direction = 1;
  }
  EXPECT_EQ(settled_friction(one), 0);
}

}  // namespace

}  // namespace host_sim::recording
