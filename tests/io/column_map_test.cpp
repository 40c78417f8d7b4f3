#include "hal/files/column_map.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>

#include "hal/files/profile_columns.hpp"

namespace hal::files {
namespace {

using testing::HasSubstr;

std::string complaint_of_map(const std::string& text) {
  try {
    column_map(text);
  } catch (const std::invalid_argument& problem) {
    return problem.what();
  }
  return "nothing";
}

TEST(ColumnMap, IsAColumnWithFactorUnitAndOffset) {
  const ColumnMap plain = column_map("force=input_tension_N");
  EXPECT_EQ(plain.channel, kInputTensionColumn);
  EXPECT_EQ(plain.column, "force");
  EXPECT_EQ(plain.scale, 1);
  EXPECT_EQ(plain.offset, 0);
  EXPECT_FALSE(plain.rate);

  const ColumnMap whole = column_map("-2.5 * \"load cell (kN)\" in kN + 3 = output_tension_N");
  EXPECT_EQ(whole.column, "load cell (kN)");
  EXPECT_EQ(whole.scale, -2500);
  EXPECT_EQ(whole.offset, 3);

  const ColumnMap kelvin = column_map("T in K=sheath_temperature_C");
  EXPECT_EQ(kelvin.scale, 1);
  EXPECT_EQ(kelvin.offset, -273.15);

  const ColumnMap rate = column_map("-0.005*rate(pos in deg)=tendon_velocity_m_s");
  EXPECT_TRUE(rate.rate);
  EXPECT_EQ(rate.column, "pos");
  EXPECT_DOUBLE_EQ(rate.scale, -0.005 * std::numbers::pi / 180);

  EXPECT_EQ(column_map("2nd in mA-0.5=motor_current_A").column, "2nd");
  EXPECT_EQ(column_map("2nd in mA-0.5=motor_current_A").offset, -0.5);
}

TEST(ColumnMap, IsANameWithBlanksAndBrackets) {
  EXPECT_EQ(column_map("Force [N]=input_tension_N").column, "Force [N]");
  EXPECT_EQ(column_map("motor angle = motor_angle_rad").column, "motor angle");
  EXPECT_EQ(column_map("\"a=b\"=time_s").column, "a=b");
  EXPECT_EQ(column_map("F -3=input_tension_N").column, "F");
  EXPECT_EQ(column_map("F -3=input_tension_N").offset, -3);
}

TEST(ColumnMap, IsWrittenForAnotherUnit) {
  EXPECT_EQ(map_of_unit("input_tension_kN", "kN", kInputTensionColumn),
            "input_tension_kN in kN=input_tension_N");
  EXPECT_EQ(map_of_unit("tendon_velocity_mm_s", "mm_s", kTendonVelocity),
            "tendon_velocity_mm_s in mm/s=tendon_velocity_m_s");
  // Needs a radius.
  EXPECT_EQ(map_of_unit("tendon_velocity_rad_s", "rad_s", kTendonVelocity), std::nullopt);
  EXPECT_EQ(map_of_unit("tendon_velocity_rpm", "rpm", kTendonVelocity), std::nullopt);
  EXPECT_EQ(map_of_unit("time_h", "h", kTime), std::nullopt);
  EXPECT_EQ(column_word("Force [N]"), "\"Force [N]\"");
}

TEST(ColumnMap, SaysWhatIsWrong) {
  EXPECT_THAT(complaint_of_map("x=force"),
              HasSubstr("unknown channel 'force'; accepted: time_s, "));
  EXPECT_THAT(complaint_of_map("x=tiem_s"),
              HasSubstr("unknown channel 'tiem_s'; accepted: time_s"));
  EXPECT_THAT(complaint_of_map("time_s"), HasSubstr("no = in front of a channel"));
  EXPECT_THAT(complaint_of_map("=time_s"), HasSubstr("no column"));
  EXPECT_THAT(complaint_of_map("\"t=time_s"),
              HasSubstr("a column that does not end with its quote"));
  EXPECT_THAT(complaint_of_map("t in h=time_s"),
              HasSubstr("unknown unit 'h'; accepted: s, ms, us, min"));
  EXPECT_THAT(complaint_of_map("rate(x=motor_angle_rad"), HasSubstr("no ) behind the column"));
  EXPECT_THAT(complaint_of_map("rate(x)+1=motor_angle_rad"), HasSubstr("a rate with an offset"));
  EXPECT_THAT(complaint_of_map("x*2=motor_angle_rad"), HasSubstr("'*2' at the end"));
  EXPECT_THAT(complaint_of_map("x+=motor_angle_rad"), HasSubstr("at the end"));
  EXPECT_THAT(complaint_of_map("0*x=motor_angle_rad"),
              HasSubstr("a factor or offset that says nothing"));
  EXPECT_THAT(complaint_of_map("1e308*x in rev=motor_angle_rad"), HasSubstr("says nothing"));
}

}  // namespace
}  // namespace hal::files
