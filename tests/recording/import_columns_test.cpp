#include "host_sim/recording/import_columns.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "host_sim/campaign/campaign.hpp"
#include "host_sim/recording/recording_files.hpp"
#include "tests/recording/support.hpp"

namespace host_sim::recording {

using enum hal::files::ProfileColumnId;
using hal::files::memory_source;

namespace {

using testing::DoubleNear;
using testing::Each;
using testing::HasSubstr;
using testing::StartsWith;

std::string complaint_of_map(const std::string& text) {
  try {
    column_map(text);
  } catch (const std::invalid_argument& problem) {
    return problem.what();
  }
  return "nothing";
}

TEST(ColumnMap, IsAColumnWithFactorUnitAndOffset) {
  const ColumnMap plain = column_map("input_tension_N=force");
  EXPECT_EQ(plain.channel, kInputTensionColumn);
  EXPECT_EQ(plain.column, "force");
  EXPECT_EQ(plain.scale, 1);
  EXPECT_EQ(plain.offset, 0);
  EXPECT_FALSE(plain.rate);

  const ColumnMap whole = column_map("output_tension_N = -2.5 * \"load cell (kN)\" in kN + 3");
  EXPECT_EQ(whole.column, "load cell (kN)");
  EXPECT_EQ(whole.scale, -2500);
  EXPECT_EQ(whole.offset, 3);

  const ColumnMap kelvin = column_map("sheath_temperature_C=T in K");
  EXPECT_EQ(kelvin.scale, 1);
  EXPECT_EQ(kelvin.offset, -273.15);

  const ColumnMap rate = column_map("tendon_velocity_m_s=-0.005*rate(pos in deg)");
  EXPECT_TRUE(rate.rate);
  EXPECT_EQ(rate.column, "pos");
  EXPECT_DOUBLE_EQ(rate.scale, -0.005 * std::numbers::pi / 180);

  EXPECT_EQ(column_map("motor_current_A=2nd in mA-0.5").column, "2nd");
  EXPECT_EQ(column_map("motor_current_A=2nd in mA-0.5").offset, -0.5);
}

TEST(ColumnMap, SaysWhatIsWrong) {
  EXPECT_THAT(complaint_of_map("force=x"),
              HasSubstr("unknown channel 'force'; accepted: time_s, "));
  EXPECT_THAT(complaint_of_map("time_s"), HasSubstr("no = behind the channel"));
  EXPECT_THAT(complaint_of_map("time_s="), HasSubstr("no column"));
  EXPECT_THAT(complaint_of_map("time_s=\"t"),
              HasSubstr("a column that does not end with its quote"));
  EXPECT_THAT(complaint_of_map("time_s=t in h"),
              HasSubstr("unknown unit 'h'; accepted: s, ms, us, min"));
  EXPECT_THAT(complaint_of_map("motor_angle_rad=rate(x"), HasSubstr("no ) behind the column"));
  EXPECT_THAT(complaint_of_map("motor_angle_rad=rate(x)+1"), HasSubstr("a rate with an offset"));
  EXPECT_THAT(complaint_of_map("motor_angle_rad=x*2"), HasSubstr("'*2' at the end"));
  EXPECT_THAT(complaint_of_map("motor_angle_rad=x+"), HasSubstr("at the end"));
  EXPECT_THAT(complaint_of_map("motor_angle_rad=0*x"),
              HasSubstr("a factor or offset that says nothing"));
  EXPECT_THAT(complaint_of_map("motor_angle_rad=1e308*x in rev"), HasSubstr("says nothing"));
}

ColumnsOptions options(std::vector<std::string> more = {}) {
  ColumnsOptions options;
  for (const char* map : {"time_s=t in ms", "input_tension_N=-F in kN", "output_tension_N=G+1",
                          "tendon_velocity_m_s=0.5*rate(angle in deg)"}) {
    options.maps.push_back(column_map(map));
  }
  for (const std::string& map : more) {
    options.maps.push_back(column_map(map));
  }
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
  EXPECT_EQ(missing_map(without), "time_s or a sample rate, one of them");
  without.rate_Hz = 200;
  EXPECT_EQ(missing_map(without), "");
  const RecordedCampaign campaign = imported(log_text(), without);
  EXPECT_DOUBLE_EQ(campaign.recordings.front()[kTime][3], 0.015);
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

TEST(ImportColumns, WhatIsMissingIsNamed) {
  const auto missing = [](std::initializer_list<const char*> maps) {
    ColumnsOptions options;
    for (const char* map : maps) {
      options.maps.push_back(column_map(map));
    }
    return missing_map(options);
  };
  EXPECT_EQ(missing({"time_s=t"}), "input_tension_N or motor_current_A");
  EXPECT_EQ(missing({"time_s=t", "motor_current_A=i"}), "output_tension_N");
  EXPECT_EQ(missing({"time_s=t", "motor_current_A=i", "output_tension_N=f"}),
            "tendon_velocity_m_s");
  EXPECT_EQ(missing({"time_s=t", "motor_current_A=i", "output_tension_N=f", "tendon_velocity_m_s=v",
                     "motor_current_A=j"}),
            "motor_current_A once");
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
            "log.csv:19:6: F is 'nan'; accepted: a finite decimal number");
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
  fast.maps.back() = column_map("tendon_velocity_m_s=1e4*rate(angle)");
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
