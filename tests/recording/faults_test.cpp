#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "host_sim/recording/recording.hpp"
#include "tests/recording/support.hpp"

namespace host_sim::recording {

using enum hal::files::ProfileColumnId;
using hal::files::ProfileColumnId;

namespace {

using FaultKind = Fault::Kind;
using test::change;
using test::Rig;

std::string all_words(const std::vector<Fault>& faults) {
  std::string words;
  for (const Fault& fault : faults) {
    words += fault.words + "\n";
  }
  return words;
}

/// Sensors from noiseless to noisy and from fine to coarse, slow and fast motion.
std::vector<Rig> rigs() {
  std::vector<Rig> all;
  for (const double frequency_Hz : {0.1, 0.5, 3.0}) {
    for (const double noise : {0.0, 0.001, 0.003, 0.01}) {
      for (const double resolution : {0.0, 0.0003, 0.002, 0.01, 0.04}) {
        for (const bool holds : {false, true}) {
          all.push_back({frequency_Hz, noise, resolution, holds, all.size() + 1});
        }
      }
    }
  }
  return all;
}

std::string text_of(const Rig& rig) {
  return "at " + std::to_string(rig.frequency_Hz) + " Hz, noise " + std::to_string(rig.noise) +
         ", resolution " + std::to_string(rig.resolution) + (rig.holds ? ", with holds" : "");
}

TEST(Faults, AreNoneInSoundRecordings) {
  for (const Rig& rig : rigs()) {
    const auto faults = faults_of({test::recording_of(rig)});
    EXPECT_TRUE(faults.empty()) << text_of(rig) << '\n' << all_words(faults);
  }
}

/// The only faults of the recording are of one kind in one channel; returns them.
std::vector<Fault> only(const Recording& recording, ProfileColumnId channel, FaultKind kind) {
  const auto faults = faults_of({recording});
  if (faults.empty()) {
    ADD_FAILURE() << "no fault";
    return {Fault{}};
  }
  for (const Fault& fault : faults) {
    EXPECT_EQ(fault.channel, channel) << fault.words;
    EXPECT_EQ(fault.kind, kind) << fault.words;
    EXPECT_EQ(fault.session, "s1");
  }
  return faults;
}

TEST(Faults, NameAChannelThatNeverChanges) {
  for (const ProfileColumnId channel :
       {kInputTensionColumn, kMotorCurrentColumn, kTendonVelocity, kMotorAngle}) {
    Recording recording = test::recording_of({});
    change(recording, channel, 0, 20, [](double) { return 7.5; });
    const auto faults = only(recording, channel, FaultKind::constant);
    ASSERT_EQ(faults.size(), 1U);
    EXPECT_EQ(faults[0].first, 0U);
    EXPECT_EQ(faults[0].count, 4000U);
  }
}

TEST(Faults, SayWhatIsConstant) {
  Recording recording = test::recording_of({});
  change(recording, kTendonVelocity, 0, 20, [](double) { return 0.05; });
  EXPECT_EQ(all_words(faults_of({recording})),
            "session 's1': tendon_velocity_m_s is 0.05 m/s in all samples; the channel is left out "
            "as if not recorded\n");
}

/// Of a weight that hangs, or of a drive that moves nothing, the load is written and not measured.
TEST(Faults, AnOutputThatNoSessionChangesIsADeadLoad) {
  std::vector<Recording> recordings{test::recording_of({}), test::recording_of({})};
  recordings[1].session = "s2";
  change(recordings[0], kOutputTensionColumn, 0, 20, [](double) { return 10.0; });
  change(recordings[1], kOutputTensionColumn, 0, 20, [](double) { return 20.0; });
  EXPECT_EQ(all_words(faults_of(recordings)),
            "session 's1': output_tension_N is 10 N in all samples, and no session changes it; it "
            "is taken for a dead load, which a load cell that does not work would look like\n"
            "session 's2': output_tension_N is 20 N in all samples, and no session changes it; it "
            "is taken for a dead load, which a load cell that does not work would look like\n");
  recordings[1] = test::recording_of({});
  EXPECT_EQ(faults_of(recordings).front().kind, FaultKind::constant);
}

/// A tendon under no load would not pull.
TEST(Faults, NoLoadIsADeadLoadOfWhatWorksBothWaysAlone) {
  Recording recording = test::recording_of({});
  change(recording, kOutputTensionColumn, 0, 20, [](double) { return 0.0; });
  EXPECT_EQ(faults_of({recording}).front().kind, FaultKind::constant);
  for (const ProfileColumnId input : {kInputTensionColumn, kMotorCurrentColumn}) {
    std::vector<Recording> each_way{recording, recording};
    for (Recording& one : each_way) {
      change(one, kInputTensionColumn, 0, 20, [](double t) { return 3 + std::sin(t); });
      change(one, kMotorCurrentColumn, 0, 20, [](double t) { return 3 + std::sin(t); });
    }
    change(each_way[1], input, 0, 20, [](double t) { return -3 + std::sin(t); });
    EXPECT_EQ(faults_of(each_way).front().kind, FaultKind::dead_load);
  }
}

TEST(Faults, NameASensorThatLosesItsNoise) {
  for (const double resolution : {0.0, 0.002}) {
    for (const ProfileColumnId channel :
         {kInputTensionColumn, kMotorCurrentColumn, kOutputTensionColumn, kTendonVelocity}) {
      Recording recording = test::recording_of({.noise = 0.003, .resolution = resolution});
      const double value = recording[channel][1030] + 1e-6;
      change(recording, channel, 5.15, 6.75, [&](double) { return value; });
      const auto faults = only(recording, channel, FaultKind::stuck);
      ASSERT_EQ(faults.size(), 1U);
      EXPECT_EQ(faults[0].first, 1030U);
      EXPECT_EQ(faults[0].count, 320U);
    }
  }
}

TEST(Faults, SayWhatIsStuck) {
  Recording recording = test::recording_of({.noise = 0.003});
  change(recording, kInputTensionColumn, 5, 6, [](double) { return 41.25; });
  EXPECT_EQ(all_words(faults_of({recording})),
            "session 's1': input_tension_N is stuck at 41.25 N from 5 s to 5.995 s, without the "
            "noise that it has elsewhere; these samples are left out\n");
}

TEST(Faults, NameASensorWithoutNoiseThatStandsStillWhileOthersMove) {
  for (const ProfileColumnId channel :
       {kInputTensionColumn, kOutputTensionColumn, kTendonVelocity, kMotorAngle}) {
    Recording recording = test::recording_of({.resolution = 0.002});
    const double value = recording[channel][820];
    change(recording, channel, 4.1, 6.0, [&](double) { return value; });
    const auto faults = only(recording, channel, FaultKind::stuck);
    ASSERT_EQ(faults.size(), 1U);
    EXPECT_EQ(faults[0].first, 820U);
    EXPECT_EQ(faults[0].count, 380U);
    EXPECT_THAT(faults[0].words, testing::HasSubstr("while other channels show motion"));
  }
}

TEST(Faults, LetTemperaturesStandStillAndTheDriveTellStandstill) {
  Recording recording = test::recording_of({.noise = 0.01});
  change(recording, kTendonVelocity, 4, 7, [](double) { return 0; });
  EXPECT_EQ(all_words(faults_of({recording})), "");
}

TEST(Faults, NameASensorThatIsClipped) {
  for (const double noise : {0.0, 0.003}) {
    for (const ProfileColumnId channel :
         {kInputTensionColumn, kMotorCurrentColumn, kOutputTensionColumn}) {
      Recording recording = test::recording_of({.noise = noise, .resolution = 0.0003});
      const std::vector<double>& values = recording[channel];
      const double top = 0.7 * *std::max_element(values.begin(), values.end());
      change(recording, channel, 0, 20, [&](double value) { return std::min(value, top); });
      const auto faults = only(recording, channel, FaultKind::saturated);
      EXPECT_GE(faults.size(), 9U);  // of ten cycles
      std::size_t touched = 0;
      for (const Fault& fault : faults) {
        touched += fault.count;
      }
      const auto clipped = static_cast<std::size_t>(std::count(values.begin(), values.end(), top));
      EXPECT_LE(touched, clipped);
      EXPECT_GE(touched, clipped * 9 / 10);
    }
  }
}

TEST(Faults, NameASensorThatIsClippedBelow) {
  Recording recording = test::recording_of({.noise = 0.003});
  change(recording, kOutputTensionColumn, 0, 20,
         [](double value) { return std::max(value, 32.0); });
  const auto faults = only(recording, kOutputTensionColumn, FaultKind::saturated);
  EXPECT_THAT(faults[0].words, testing::HasSubstr("output_tension_N stays at 32 N, its smallest "
                                                  "value, from "));
}

TEST(Faults, NameGapsInTime) {
  Recording recording = test::recording_of({.noise = 0.003});
  for (auto& values : recording.channels) {
    values.erase(values.begin() + 1000, values.begin() + 1005);
    values.erase(values.begin() + 500, values.begin() + 504);
  }
  const auto faults = only(recording, kTime, FaultKind::gap);
  ASSERT_EQ(faults.size(), 1U);  // four samples are missing in the other: 5 steps, not more
  EXPECT_EQ(faults[0].first, 996U);
  EXPECT_EQ(faults[0].count, 1U);
  EXPECT_EQ(faults[0].words,
            "session 's1': no samples from 4.995 s to 5.025 s; direction and travel are taken up "
            "anew behind the gap");
}

TEST(Faults, NameAColumnThatWasPassedOverAndIsNearlyOneOfOurs) {
  const Recording sound = test::recording_of({.noise = 0.003});
  Recording doubtful = sound;
  doubtful.nearly = {{kMotorAngle, "column 'motor_angel_rad' is passed over"}};
  ASSERT_EQ(faults_of({sound}).size(), 0U);
  const auto faults = faults_of({doubtful});
  ASSERT_EQ(faults.size(), 1U) << all_words(faults);
  EXPECT_EQ(faults[0].kind, FaultKind::passed_over);
  EXPECT_EQ(faults[0].channel, kMotorAngle);
  EXPECT_EQ(faults[0].count, 0U);
  EXPECT_EQ(faults[0].words, "session 's1': column 'motor_angel_rad' is passed over");
}

TEST(Faults, AreNoneOfForcesThatChangeSign) {
  Recording recording = test::recording_of({});
  for (const ProfileColumnId id :
       {kInputTensionColumn, kMotorCurrentColumn, kOutputTensionColumn}) {
    const auto [low, high] = std::ranges::minmax_element(recording.channels[id]);
    const double middle = (*low + *high) / 2;
    change(recording, id, 0, 20, [middle](double value) { return value - middle; });
  }
  EXPECT_EQ(all_words(faults_of({recording})), "");
}

TEST(Faults, ComeInOrderOfSessionAndChannel) {
  Recording first = test::recording_of({});
  change(first, kOutputTensionColumn, 0, 20, [](double) { return 3; });
  change(first, kInputTensionColumn, 0, 20, [](double) { return 3; });
  Recording second = test::recording_of({});
  second.session = "s2";
  change(second, kInputTensionColumn, 0, 20, [](double) { return 3; });
  const auto faults = faults_of({first, second});
  ASSERT_EQ(faults.size(), 3U);
  EXPECT_EQ(faults[0].channel, kInputTensionColumn);
  EXPECT_EQ(faults[1].channel, kOutputTensionColumn);
  EXPECT_EQ(faults[2].session, "s2");
}

TEST(FaultSummary, IsOneLineForEachKindAndChannel) {
  const std::vector<Fault> faults{
      {"s1", kTime, FaultKind::gap, 5, 1, "a gap"},
      {"s1", kOutputTensionColumn, FaultKind::saturated, 5, 10, "at its end"},
      {"s1", kOutputTensionColumn, FaultKind::saturated, 50, 20, "at its end again"},
      {"s2", kOutputTensionColumn, FaultKind::stuck, 50, 7, "stuck"},
      {"s2", kOutputTensionColumn, FaultKind::saturated, 5, 3, "at its end there"},
  };
  const auto summaries = summary_of(faults);
  ASSERT_EQ(summaries.size(), 3U);
  EXPECT_EQ(summaries[0].words, "a gap");
  EXPECT_EQ(summaries[1].kind, FaultKind::stuck);
  EXPECT_EQ(summaries[2].words, "at its end; 3 times like this, in 2 sessions and 33 samples");
  EXPECT_EQ(summaries[2].sessions, 2U);
  EXPECT_EQ(summaries[2].samples, 33U);
  EXPECT_TRUE(summary_of({}).empty());
}

}  // namespace
}  // namespace host_sim::recording
