#include "hal/files/profile.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <string>

#include "tests/io/support.hpp"

namespace host_sim {

using hal::files::input_kind_from;
using hal::files::InputKind;
using enum hal::files::ProfileColumnId;
using hal::files::memory_source;
using hal::files::ProfileChannels;
using hal::files::ProfileReader;
using hal::files::ProfileRow;

namespace {

using test::rows_of;

void expect_row(const ProfileRow& row, double time_s, double value, double velocity_m_s = 0.0,
                double bend_deg = 0.0) {
  EXPECT_EQ(row.time_s, time_s);
  EXPECT_EQ(row.value, value);
  EXPECT_EQ(row.tendon_velocity_m_s, velocity_m_s);
  EXPECT_EQ(row.bend_angle_deg, bend_deg);
}

TEST(Profile, ReadsInputTension) {
  ProfileReader reader(memory_source("time_s,input_tension_N\n0,10\n0.5,-2.5e1\n"), "p.csv");
  EXPECT_EQ(reader.kind(), InputKind::kInputTension);
  EXPECT_FALSE(reader.has_bend_angle());
  std::array<ProfileRow, 8> rows{};
  ASSERT_EQ(reader.read(rows), 2U);
  expect_row(rows[0], 0.0, 10.0);
  expect_row(rows[1], 0.5, -25.0);
  EXPECT_EQ(reader.read(rows), 0U);
  EXPECT_EQ(reader.read(rows), 0U);
}

TEST(Profile, ReadsMotorCurrent) {
  ProfileReader reader(memory_source("motor_current_A,time_s\n1.5,0\n"), "p.csv");
  EXPECT_EQ(reader.kind(), InputKind::kMotorCurrent);
  std::array<ProfileRow, 1> rows{};
  ASSERT_EQ(reader.read(rows), 1U);
  expect_row(rows[0], 0.0, 1.5);
}

TEST(Profile, ReadsOutputTensionVelocityAndBend) {
  ProfileReader reader(memory_source("bend_angle_deg,tendon_velocity_m_s,output_tension_N,time_s\n"
                                     "270,-0.05,38.5,1\n"),
                       "p.csv");
  EXPECT_EQ(reader.kind(), InputKind::kOutputTension);
  EXPECT_TRUE(reader.has_bend_angle());
  std::array<ProfileRow, 1> rows{};
  ASSERT_EQ(reader.read(rows), 1U);
  expect_row(rows[0], 1.0, 38.5, -0.05, 270.0);
}

TEST(Profile, PrefersInputTensionThenCurrentUnlessTold) {
  const std::string text =
      "time_s,output_tension_N,tendon_velocity_m_s,bend_angle_deg,motor_current_A,input_tension_N\n"
      "0,1,2,3,4,5\n";
  expect_row(rows_of(text).at(0), 0.0, 5.0, 2.0);
  expect_row(rows_of(text, {InputKind::kMotorCurrent}).at(0), 0.0, 4.0, 2.0);
  expect_row(rows_of(text, {InputKind::kOutputTension}).at(0), 0.0, 1.0, 2.0, 3.0);
  expect_row(
      rows_of("time_s,output_tension_N,tendon_velocity_m_s,motor_current_A\n0,1,2,4\n").at(0), 0.0,
      4.0, 2.0);
}

TEST(Profile, TellsWhichColumnsItHolds) {
  ProfileReader reader(memory_source("time_s,sheath_temperature_C,input_tension_N\n0,20,5\n"),
                       "p.csv");
  EXPECT_EQ(reader.channels(),
            ProfileChannels{}.set(kTime).set(kSheathTemperature).set(kInputTensionColumn));
}

TEST(Profile, TakesATensionWithoutTheVelocityThatItsKindDoesNotNeed) {
  expect_row(rows_of("time_s,output_tension_N,input_tension_N\n0,1,5\n").at(0), 0.0, 5.0);
}

TEST(Profile, KeepsOtherColumnsOutOfTheWay) {
  const auto rows = rows_of(
      "motor_angle_rad,time_s,sheath_temperature_C,input_tension_N,winding_temperature_C\n"
      "9,0,20,1,60\n");
  expect_row(rows.at(0), 0.0, 1.0);
  EXPECT_EQ(rows.at(0).motor_angle_rad, 9);
  EXPECT_EQ(rows.at(0).sheath_temperature_C, 20);
  EXPECT_EQ(rows.at(0).winding_temperature_C, 60);
}

TEST(Profile, AcceptsQuotesLineEndsCommentsAndByteOrderMark) {
  const auto rows = rows_of(
      "\xEF\xBB\xBF# recorded, \"on\" a Monday\n"
      "\"time_s\",input_tension_N\r\n"
      "# a, b, c\r\n"
      "\"0\",\"1\"\r\n"
      "#\n"
      "1,\"2\"\n"
      "+2,+3\r\n"
      "# the last line has no end\n"
      "3,4");
  ASSERT_EQ(rows.size(), 4U);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    expect_row(rows[i], static_cast<double>(i), static_cast<double>(i) + 1.0);
  }
}

TEST(Profile, AcceptsACommentAsLastLine) {
  EXPECT_EQ(rows_of("time_s,input_tension_N\n0,1\n# end").size(), 1U);
}

TEST(Profile, AcceptsNegativeStartAndGapsInTime) {
  const auto rows = rows_of("time_s,input_tension_N\n-5,1\n0,1\n1000000,1\n");
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[2].time_s, 1e6);
}

TEST(Profile, AcceptsTheEndsOfTheRanges) {
  const auto rows = rows_of(
      "time_s,output_tension_N,tendon_velocity_m_s,bend_angle_deg\n"
      "0,-1e6,-1000,0\n"
      "1,1e6,1000,1800\n");
  expect_row(rows.at(0), 0.0, -1e6, -1000.0, 0.0);
  expect_row(rows.at(1), 1.0, 1e6, 1000.0, 1800.0);
}

TEST(Profile, CountsBytes) {
  const std::string text = "time_s,input_tension_N\n0,1\n1,2";
  ProfileReader reader(memory_source(text), "p.csv");
  EXPECT_EQ(reader.bytes_total(), text.size());
  std::array<ProfileRow, 1> rows{};
  ASSERT_EQ(reader.read(rows), 1U);
  EXPECT_EQ(reader.bytes_read(), text.size() - 3);
  ASSERT_EQ(reader.read(rows), 1U);
  ASSERT_EQ(reader.read(rows), 0U);
  EXPECT_EQ(reader.bytes_read(), text.size());
}

TEST(Profile, ReadsFiles) {
  const test::TemporaryFolder folder;
  const std::string text = "time_s,input_tension_N\n0,1\n1,2\n";
  test::write_text(folder / "run.csv", text);
  ProfileReader reader(folder / "run.csv");
  EXPECT_EQ(reader.bytes_total(), text.size());
  std::array<ProfileRow, 4> rows{};
  EXPECT_EQ(reader.read(rows), 2U);
}

TEST(Profile, ReadsStandardInput) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  const int standard_input = ::dup(STDIN_FILENO);
  ASSERT_EQ(::dup2(ends[0], STDIN_FILENO), STDIN_FILENO);
  const std::string text = "time_s,input_tension_N\n0,1\n1,2\n";
  ASSERT_EQ(::write(ends[1], text.data(), text.size()), static_cast<ssize_t>(text.size()));
  ::close(ends[1]);
  {
    ProfileReader reader("-");
    EXPECT_EQ(reader.bytes_total(), 0U);
    std::array<ProfileRow, 4> rows{};
    EXPECT_EQ(reader.read(rows), 2U);
    EXPECT_EQ(reader.bytes_read(), text.size());
  }
  EXPECT_EQ(::dup2(standard_input, STDIN_FILENO), STDIN_FILENO);
  ::close(standard_input);
  ::close(ends[0]);
}

TEST(InputKindNames, GoBothWays) {
  for (const InputKind kind :
       {InputKind::kInputTension, InputKind::kMotorCurrent, InputKind::kOutputTension}) {
    EXPECT_EQ(input_kind_from(to_string(kind)), kind);
  }
  EXPECT_EQ(input_kind_from("motor_current"), InputKind::kMotorCurrent);
  EXPECT_EQ(input_kind_from("torque"), std::nullopt);
}

}  // namespace
}  // namespace host_sim
