#include "host_sim/recording/import_columns.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

#include "host_sim/campaign/campaign.hpp"
#include "host_sim/recording/recording_files.hpp"
#include "tests/recording/support.hpp"

namespace host_sim::recording {

using enum hal::files::ProfileColumnId;
using hal::files::column_map;
using hal::files::memory_source;

namespace {

using testing::DoubleNear;
using testing::Each;
using testing::StartsWith;

ColumnsOptions options(std::vector<std::string> more = {}) {
  ColumnsOptions options;
  for (const char* map : {"t in ms=time_s", "-F in kN=input_tension_N", "G+1=output_tension_N",
                          "0.5*rate(angle in deg)=tendon_velocity_m_s"}) {
    options.maps.push_back(column_map(map));
  }
  for (const std::string& map : more) {
    options.maps.push_back(column_map(map));
  }
  return options;
}

ColumnsOptions with_rate(ColumnsOptions options) {
  options.rate_Hz = 200;
  return options;
}

/// The angle grows by 90 degrees in a tenth of a second.
std::string log_text(std::string_view delimiter = ",", int rows = 16) {
  std::string text = "# a comment\nt,F,G,angle,note\n";
  for (int i = 0; i < rows; ++i) {
    text += std::to_string(100 * i) + ",-0.04,19," + std::to_string(90 * i) + ",x\n";
  }
  for (std::size_t at = text.find(','); at != std::string::npos; at = text.find(',', at + 1)) {
    text.replace(at, 1, delimiter);
  }
  return text;
}

RecordedCampaign imported(const std::string& text, const ColumnsOptions& options) {
  RecordedCampaign campaign;
  import_columns(memory_source(text), "log.csv", "my log", options, campaign);
  return campaign;
}

TEST(ImportColumns, ConvertsUnitsSignsAndRates) {
  for (const char* delimiter : {",", ";", "\t"}) {
    const RecordedCampaign campaign = imported(log_text(delimiter), options());
    ASSERT_EQ(campaign.recordings.size(), 1U);
    const Recording& recording = campaign.recordings.front();
    EXPECT_EQ(recording.session, "my_log");
    EXPECT_EQ(recording.samples(), 16U);
    EXPECT_DOUBLE_EQ(recording[kTime][3], 0.3);
    EXPECT_THAT(recording[kInputTensionColumn], Each(40));
    EXPECT_THAT(recording[kOutputTensionColumn], Each(20));
    // 900 degrees a second, half a metre a radian.
    EXPECT_THAT(recording[kTendonVelocity], Each(DoubleNear(0.5 * 5 * std::numbers::pi, 1e-9)));
    EXPECT_FALSE(recording.has(kMotorAngle));
  }
}

TEST(ImportColumns, ASampleRateStandsForTheTime) {
  ColumnsOptions without = options();
  without.maps.erase(without.maps.begin());
  EXPECT_EQ(test::complaint_of([&] { imported(log_text(), without); }),
            "log.csv:2:1: no column for time_s; accepted: --column COLUMN=time_s, or "
            "--sample-rate-Hz");
  without.rate_Hz = 200;
  EXPECT_EQ(conflict_of(without), "");
  EXPECT_EQ(conflict_of(with_rate(options())), "time_s or a sample rate, one of them");
  const RecordedCampaign campaign = imported(log_text(), without);
  EXPECT_DOUBLE_EQ(campaign.recordings.front()[kTime][3], 0.015);
}

TEST(ImportColumns, ADeadLoadStandsForTheOutput) {
  ColumnsOptions without = options();
  without.maps.erase(without.maps.begin() + 2);
  without.dead_load_N = 25;
  EXPECT_EQ(conflict_of(without), "");
  EXPECT_THAT(imported(log_text(), without).recordings.front()[kOutputTensionColumn], Each(25));
  ColumnsOptions both = options();
  both.dead_load_N = 25;
  EXPECT_EQ(conflict_of(both), "output_tension_N or a dead load, one of them");
}

TEST(ImportColumns, AColumnDividesATableIntoSessions) {
  ColumnsOptions by = options();
  by.session_column = "note";
  std::string text = log_text();
  for (int i = 0; i < 16; ++i) {
    text += std::to_string(i) + ",-0.01,9," + std::to_string(i) + ",load 2\n";
  }
  const RecordedCampaign campaign = imported(text, by);
  ASSERT_EQ(campaign.recordings.size(), 2U);
  EXPECT_EQ(campaign.recordings[0].session, "load_2");
  EXPECT_EQ(campaign.recordings[1].session, "x");
  EXPECT_THAT(campaign.recordings[0][kInputTensionColumn], Each(10));
}

TEST(ImportColumns, TakesWhatHasTheNameOfAChannel) {
  std::string text = "time_s;output_tension_N;f;tendon_velocity_m_s;note\n";
  for (int i = 0; i < 16; ++i) {
    text += std::to_string(i) + ";20;19;0.5;x\n";
  }
  ColumnsOptions one;
  one.maps.push_back(column_map("2*f=input_tension_N"));
  const Recording recording = imported(text, one).recordings.front();
  EXPECT_THAT(recording[kInputTensionColumn], Each(38));
  EXPECT_THAT(recording[kOutputTensionColumn], Each(20));
  EXPECT_THAT(recording[kTendonVelocity], Each(0.5));
  EXPECT_EQ(recording[kTime][7], 7);
  // A map goes before the name.
  one.maps.push_back(column_map("f=output_tension_N"));
  EXPECT_THAT(imported(text, one).recordings.front()[kOutputTensionColumn], Each(19));
}

TEST(ImportColumns, WhatIsMissingIsNamed) {
  const auto missing = [](const std::string& header) {
    return test::complaint_of([&] { imported(header + "\n", {}); });
  };
  EXPECT_EQ(missing("time_s,x"),
            "log.csv:1:1: no column for input_tension_N; accepted: --column "
            "COLUMN=input_tension_N, or motor_current_A");
  EXPECT_EQ(missing("time_s,motor_current_A"),
            "log.csv:1:1: no column for output_tension_N; accepted: --column "
            "COLUMN=output_tension_N, or --dead-load-N");
  EXPECT_EQ(missing("time_s,motor_current_A,output_tension_N"),
            "log.csv:1:1: no column for tendon_velocity_m_s; accepted: --column "
            "COLUMN=tendon_velocity_m_s, or of a position in m --column "
            "'rate(COLUMN)=tendon_velocity_m_s'");
  EXPECT_EQ(conflict_of(options({"i=motor_current_A", "j=motor_current_A"})),
            "motor_current_A once");
}

TEST(ImportColumns, RowsWithoutAValueArePassedOverWhereThatIsAskedFor) {
  const std::string text =
      log_text() + "1600,NaN,19,1440,x\n1700,-0.04,,1530,x\n" + "1800,-0.04,19,1620,\n";
  ColumnsOptions passing = options();
  passing.ignore_missing = true;
  const RecordedCampaign campaign = imported(text, passing);
  EXPECT_EQ(campaign.passed_over, 2U);
  const Recording& recording = campaign.recordings.front();
  ASSERT_EQ(recording.samples(), 17U);
  EXPECT_DOUBLE_EQ(recording[kTime].back(), 1.8);
  // By a rate of samples their time goes on.
  passing.maps.erase(passing.maps.begin());
  passing.rate_Hz = 10;
  EXPECT_DOUBLE_EQ(imported(text, passing).recordings.front()[kTime].back(), 1.8);
}

TEST(ImportColumns, SaysWhereATableIsWrong) {
  const auto complaint = [](const std::string& text, const ColumnsOptions& options) {
    return test::complaint_of([&] { imported(text, options); });
  };
  EXPECT_EQ(complaint("", options()),
            "log.csv: the file is empty; accepted: a table with a line of names");
  EXPECT_EQ(complaint("t,F,G\n", options()),
            "log.csv:1:1: no column 'angle'; accepted: one of t, F, G");
  EXPECT_EQ(complaint("t,t,F,G,angle\n", options()),
            "log.csv:1:1: more than one column 't'; accepted: one of t, t, F, G, angle");
  EXPECT_EQ(complaint("t,F,G,angle,note\n", options()),
            "log.csv: no rows; accepted: at least one row after the line of names");
  EXPECT_EQ(complaint(log_text() + "1,2\n", options()),
            "log.csv:19:1: 2 fields; accepted: 5, as in the line of names");
  EXPECT_EQ(complaint(log_text() + "9999,nan,1,1,x\n", options()),
            "log.csv:19:6: F is 'nan', not a finite number; accepted: a finite decimal number "
            "without spaces, or --ignore-missing to pass such rows over");
  EXPECT_EQ(complaint("0.1,2,3\n0.2,2,3\n", options()),
            "log.csv:1:1: numbers in the first line; accepted: a line with the names of the "
            "columns before it");
  EXPECT_EQ(complaint(log_text() + "9999,2000,1,1,x\n", options()),
            "log.csv:19:6: input_tension_N becomes -2000000; accepted: -1000000..1000000");
  EXPECT_EQ(
      complaint(log_text() + "3,1,1,1,x\n", options()),
      "log.csv:19:1: time goes from 1.5 s to 0.003 s; accepted: time that increases within each "
      "session");
  EXPECT_EQ(complaint(log_text(",", 15), options()),
            "log.csv: 15 samples of session my_log; accepted: at least 16");
  EXPECT_EQ(
      complaint(log_text() + "\"1,2\n", options()),
      "log.csv:19:1: a quoted field that does not end with its quote; accepted: a field with both "
      "quotes, or without");

  ColumnsOptions fast = options();
  fast.maps.back() = column_map("1e4*rate(angle)=tendon_velocity_m_s");
  EXPECT_EQ(complaint(log_text(), fast),
            "log.csv: tendon_velocity_m_s becomes 9000000 at 0 s; accepted: -1000..1000");

  RecordedCampaign twice = imported(log_text(), options());
  EXPECT_EQ(
      test::complaint_of([&] {
        import_columns(memory_source(log_text()), "other.csv", "my-log", options(), twice);
      }),
      "other.csv: session 'my_log' a second time; accepted: files or values of a session's column "
      "whose letters and digits differ");
}

TEST(ImportColumns, WritesACampaignThatIsReadAsItWasMapped) {
  const test::TemporaryFolder folder;
  RecordedCampaign campaign = imported(log_text(), options());
  campaign.campaign_toml = unknown_campaign("my drive", false);
  write_campaign(campaign, folder / "drive");
  const auto recordings = read_recordings(folder / "drive");
  ASSERT_EQ(recordings.size(), 1U);
  EXPECT_EQ(recordings[0].channels, campaign.recordings[0].channels);
  EXPECT_EQ(read_campaign(folder / "drive").name, "my_drive");
  EXPECT_FALSE(read_campaign(folder / "drive").two_sided);
}

TEST(ImportColumns, WritesWhetherTheDriveWorksInBothDirections) {
  const test::TemporaryFolder folder;
  RecordedCampaign campaign = imported(log_text(), options());
  campaign.campaign_toml = unknown_campaign("joint", true);
  write_campaign(campaign, folder / "joint");
  EXPECT_TRUE(read_campaign(folder / "joint").two_sided);
  EXPECT_THAT(unknown_campaign("joint", true),
              StartsWith("[campaign]\nname = \"joint\"\ntwo_sided = true\n\n# Of sheath"));
  EXPECT_THAT(unknown_campaign("joint", false),
              StartsWith("[campaign]\nname = \"joint\"\n\n# Of sheath"));
}

}  // namespace
}  // namespace host_sim::recording
