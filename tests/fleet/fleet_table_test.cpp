#include "host_sim/fleet/fleet_table.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "hal/files/input_error.hpp"

namespace {

using hal::files::InputError;
using host_sim::fleet::fleet_table_text;
using host_sim::fleet::parse_fleet_table;
using host_sim::fleet::TendonRow;

std::vector<TendonRow> parse(const std::string& text) {
  return parse_fleet_table(hal::files::memory_source(text), "t.csv");
}

TEST(FleetTable, HasATendonInEachRow) {
  const auto rows = parse(
      "# of the field\n"
      "hours_per_day,tendon,damage,damage_per_h,rate_log_sd,effective_tension_N,model,cost_replace,"
      "cost_break\n"
      "8,left,0.25,1e-4,0.2,38.5,m/a.toml,120,900\n"
      "24,\"right, upper\",0,0,,,,,\n");
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].tendon.name, "left");
  EXPECT_EQ(rows[0].tendon.damage, 0.25);
  EXPECT_EQ(rows[0].tendon.damage_per_h, 1e-4);
  EXPECT_EQ(rows[0].tendon.rate_log_sd, 0.2);
  EXPECT_EQ(rows[0].tendon.hours_per_day, 8);
  EXPECT_EQ(rows[0].tendon.effective_tension_N, 38.5);
  EXPECT_EQ(rows[0].tendon.replacement_cost, 120);
  EXPECT_EQ(rows[0].tendon.break_cost, 900);
  EXPECT_EQ(rows[0].model, "m/a.toml");
  EXPECT_EQ(rows[1].tendon.name, "right, upper");
  EXPECT_EQ(rows[1].tendon.rate_log_sd, 0);
  EXPECT_FALSE(rows[1].tendon.effective_tension_N);
  EXPECT_FALSE(rows[1].tendon.break_cost);
  EXPECT_EQ(models_of(rows, "fleets/t.csv"),
            (std::vector<std::filesystem::path>{"fleets/m/a.toml"}));
}

TEST(FleetTable, TakesTheMeanRateOfAnAge) {
  const auto rows = parse(
      "tendon,damage,damage_per_h,age_h,hours_per_day\n"
      "a,0.5,,250,8\n"
      "b,0.5,1e-3,250,8\n");
  EXPECT_EQ(rows[0].tendon.damage_per_h, 0.002);
  EXPECT_EQ(rows[1].tendon.damage_per_h, 0.001);
}

TEST(FleetTable, RefusesWithThePlaceWhatCannotBeTrusted) {
  const std::string head = "tendon,damage,damage_per_h,hours_per_day\n";
  const std::vector<std::pair<std::string, std::string>> cases{
      {"", "t.csv: the file is empty; accepted: a CSV file with tendon, damage_per_h, damage, "},
      {head, "t.csv: no rows; accepted: at least one row"},
      {"tendon,damage,damage_per_h,hours_per_day,wear\na,0,0,8,1\n",
       "t.csv:1:42: unknown column 'wear'; accepted: tendon, damage_per_h, damage, age_h"},
      {"tendon,damage,damage_per_d,hours_per_day\na,0,0,8\n",
       "t.csv:1:15: unknown unit 'per_d' of column 'damage_per_d'; accepted: damage_per_h"},
      {"tendon,damage,damage_per_h\na,0,0\n", "t.csv:1:27: no column hours_per_day"},
      {"tendon,damage,hours_per_day\na,0,8\n",
       "t.csv:1:28: no column damage_per_h and none age_h; accepted: one of them"},
      {head + "a,-0.1,0,8\n", "t.csv:2:3: damage is '-0.1', out of range; accepted: 0..100"},
      {head + "a,nan,0,8\n", "t.csv:2:3: damage is 'nan', not a finite number"},
      {head + "a,0.1,-1e-9,8\n", "t.csv:2:7: damage_per_h is '-1e-9', out of range"},
      {head + "a,0.1,0,25\n", "t.csv:2:9: hours_per_day is '25', out of range; accepted: 0..24"},
      {head + "a,0.1,,8\n",
       "t.csv:2:7: a tendon without a rate; accepted: damage_per_h, or age_h in hours"},
      {head + ",0.1,0,8\n", "t.csv:2:1: tendon is empty; accepted: the name of a tendon"},
      {head + "a,0.1,0,8\nb,0,0,8\na,0.2,0,8\n",
       "t.csv:4:1: tendon 'a' a second time, first in line 2; accepted: one row for each tendon"},
      {head + "a,0.1,0\n", "t.csv:2:8: 3 fields only; accepted: 4 fields"},
  };
  for (const auto& [text, message] : cases) {
    try {
      parse(text);
      ADD_FAILURE() << text;
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).substr(0, message.size()), message) << text;
    }
  }
}

TEST(FleetTable, AnAgeThatIsTooShortIsRefused) {
  EXPECT_THROW(parse("tendon,damage,age_h,hours_per_day\na,50,0.1,8\n"), InputError);
  EXPECT_THROW(parse("tendon,damage,age_h,hours_per_day\na,50,0,8\n"), InputError);
}

TEST(FleetTable, OfWhatWasReadIsReadAgain) {
  TendonRow row;
  row.tendon.name = "r,1/3/0";
  row.tendon.damage = 0.123456789;
  row.tendon.damage_per_h = 1e-7;
  row.tendon.rate_log_sd = 0.25;
  row.tendon.hours_per_day = 7.5;
  const std::string text = fleet_table_text({row}, {"r1/3/1"});
  EXPECT_EQ(text,
            "# broken: r1/3/1\n"
            "tendon,damage,damage_per_h,age_h,rate_log_sd,hours_per_day\n"
            "\"r,1/3/0\",0.123456789,1e-07,,0.25,7.5\n");
  const auto again = parse(text);
  EXPECT_EQ(again.at(0).tendon.name, row.tendon.name);
  EXPECT_EQ(again.at(0).tendon.damage, row.tendon.damage);
  EXPECT_EQ(again.at(0).tendon.damage_per_h, row.tendon.damage_per_h);
}

}  // namespace
