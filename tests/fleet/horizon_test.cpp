#include "host_sim/fleet/horizon.hpp"

#include <gtest/gtest.h>

#include <string>

namespace {

using namespace host_sim::fleet;
using std::chrono::days;

Date day(const std::string& text) {
  return parse_date(text).value();
}

TEST(FleetDate, CountsDaysOfTheGregorianCalendar) {
  EXPECT_EQ(day("1970-01-01").time_since_epoch(), days(0));
  EXPECT_EQ(day("2000-03-01") - day("2000-02-28"), days(2));  // divisible by 400
  EXPECT_EQ(day("2100-03-01") - day("2100-02-28"), days(1));  // by 100 alone
  EXPECT_EQ(date_text(day("2026-03-02") + days(365)), "2027-03-02");
  EXPECT_EQ(date_text(day("9899-12-31")), "9899-12-31");
}

TEST(FleetDate, IsNothingElse) {
  for (const char* const text :
       {"", "2026-3-2", "2026-02-29", "2026-13-01", "2026-00-01", "2026-01-32", "2026-01-00",
        "26-01-01", "2026/01/01", "2026-01-01T00", " 2026-01-01", "+026-01-01", "1969-12-31",
        "9900-01-01", "today", "2026-01-0x"}) {
    EXPECT_FALSE(parse_date(text)) << text;
  }
}

TEST(FleetHorizon, IsInDaysWeeksMonthsHoursOrUntilADate) {
  const Date today = day("2026-03-02");
  const auto length = [&](const char* text) { return parse_horizon(text, today).value(); };
  EXPECT_EQ(length("90d").length, 90);
  EXPECT_EQ(length("12w").length, 84);
  EXPECT_DOUBLE_EQ(length("6m").length, 182.625);  // half of 365.25
  EXPECT_EQ(length("0.5d").length, 0.5);
  EXPECT_EQ(length("2026-03-12").length, 10);
  EXPECT_EQ(length("90d").hours(8), 720);
  EXPECT_EQ(length("2000h").length, 2000);
  EXPECT_EQ(length("2000h").hours(8), 2000);  // of operation, however long that takes
  EXPECT_EQ(length("36525d").length, 36525);
}

TEST(FleetHorizon, IsNothingElse) {
  for (const char* const text :
       {"", "90", "d", "0d", "-1d", "nand", "infd", "1e9d", "90 d", "90days", "90s", "90D", "1y",
        "2026-03-02", "2026-03-01", "2026-02-30", "36526d", "876601h", "1200.5m"}) {
    EXPECT_FALSE(parse_horizon(text, day("2026-03-02"))) << text;
  }
}

}  // namespace
