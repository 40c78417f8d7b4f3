#include "host_sim/recording/recording_file.hpp"

#include <gtest/gtest.h>

#include <string>

#include "tests/recording/support.hpp"

namespace host_sim::recording {
namespace {

std::string complaint_about(std::string_view text) {
  return test::complaint_of([&] { parse_recording(memory_source(text), "r.csv"); });
}

TEST(RecordingFile, GivesAllChannelsInTheirOwnPlaces) {
  std::string text =
      "# all\nwinding_temperature_C,tendon_velocity_m_s,motor_current_A,time_s,output_tension_N,"
      "input_tension_N,bend_angle_deg,motor_angle_rad,sheath_temperature_C\r\n";
  for (int i = 0; i < 16; ++i) {
    text += "41,-0.5,1.25," + std::to_string(i) + ",20.5,40,270,3," + std::to_string(20 + i) +
            "\r\n# a comment\r\n";
  }
  const Channels channels = parse_recording(memory_source(text), "r.csv");
  const std::array<double, kProfileColumnCount> last{15, 40, 1.25, 20.5, -0.5, 270, 3, 35, 41};
  for (std::size_t id = 0; id < kProfileColumnCount; ++id) {
    ASSERT_EQ(channels[id].size(), 16U) << id;
    EXPECT_EQ(channels[id].back(), last[id]) << id;
  }
  EXPECT_EQ(channels[kTime].front(), 0);
  EXPECT_EQ(channels[kSheathTemperature][3], 23);
}

TEST(RecordingFile, LeavesChannelsEmptyThatItLacks) {
  const Channels channels = parse_recording(memory_source(test::recording_text()), "r.csv");
  EXPECT_EQ(channels[kInputTensionColumn].size(), 16U);
  EXPECT_TRUE(channels[kMotorCurrentColumn].empty());
  EXPECT_TRUE(channels[kSheathTemperature].empty());
}

constexpr std::string_view kAccepted =
    "; accepted: time_s, output_tension_N, tendon_velocity_m_s, and input_tension_N or "
    "motor_current_A or both";

TEST(RecordingFile, RefusesAFileWithoutAnInputAnOutputOrAVelocity) {
  EXPECT_EQ(complaint_about("time_s,output_tension_N,tendon_velocity_m_s\n"),
            "r.csv:1:44: no column input_tension_N or motor_current_A" + std::string(kAccepted));
  EXPECT_EQ(complaint_about("time_s,motor_current_A,tendon_velocity_m_s\n"),
            "r.csv:1:43: no column output_tension_N" + std::string(kAccepted));
  EXPECT_EQ(complaint_about("time_s,motor_current_A,output_tension_N\n"),
            "r.csv:1:40: no column tendon_velocity_m_s" + std::string(kAccepted));
  EXPECT_EQ(complaint_about("motor_current_A,output_tension_N,tendon_velocity_m_s\n"),
            "r.csv:1:53: no column time_s" + std::string(kAccepted));
}

TEST(RecordingFile, RefusesColumnsThatItDoesNotKnow) {
  EXPECT_EQ(complaint_about("time_s,input_tension_kN\n"),
            "r.csv:1:8: unknown unit 'kN' of column 'input_tension_kN'; accepted: "
            "input_tension_N");
  EXPECT_EQ(complaint_about("time_ms\n"),
            "r.csv:1:1: unknown unit 'ms' of column 'time_ms'; accepted: time_s");
  EXPECT_EQ(complaint_about("time_s,sag_m\n").rfind("r.csv:1:8: unknown column 'sag_m'", 0), 0U);
}

TEST(RecordingFile, RefusesAFileThatIsEmptyOrTooShort) {
  EXPECT_EQ(complaint_about(""), "r.csv: the file is empty; accepted: a CSV file with " +
                                     std::string(kAccepted.substr(12)));
  EXPECT_EQ(complaint_about(test::kRecordingHeader),
            "r.csv: no rows; accepted: at least one row after the header");
  EXPECT_EQ(complaint_about(test::recording_text(15)),
            "r.csv:17: the file ends after 15 samples; accepted: at least 16 samples");
  EXPECT_EQ(complaint_about(test::recording_text(16)), "");
}

TEST(RecordingFile, RefusesRowsThatCannotBeTrusted) {
  const auto with = [](const char* row) { return complaint_about(test::recording_text() + row); };
  EXPECT_EQ(with("0.001,40,20,0.1\n"),
            "r.csv:18:1: time runs back from 0.075 s to 0.001 s; accepted: time that increases "
            "from row to row");
  EXPECT_EQ(with("1,nan,20,0.1\n"),
            "r.csv:18:3: input_tension_N is 'nan', not a finite number; accepted: a finite "
            "decimal number without spaces");
  EXPECT_EQ(with("1,40,20\n"), "r.csv:18:8: 3 fields only; accepted: 4 fields, as in the header");
  EXPECT_EQ(with("1,40,2e7,0.1\n"),
            "r.csv:18:6: output_tension_N is '2e7', out of range; accepted: -1000000..1000000 N");
}

}  // namespace
}  // namespace host_sim::recording
