#include <gtest/gtest.h>

#include <algorithm>

#include "host_sim/calibrate/output/output.hpp"
#include "tests/verbs/hand_made_result.hpp"

namespace {

using namespace host_sim::calibrate;

TEST(CalibrateTable, HasWhatWasFitted) {
  EXPECT_EQ(table_row("one", host_sim_test::hand_made_result()),
            "one,9,6,3,5.94,5,7,0.5,200000,100000,inf,1.5,1.25,1.75,6,5,7,-123.456,0.25,1,"
            "left-out,2,\n");
}

TEST(CalibrateTable, LeavesEmptyWhatWasNotFitted) {
  EXPECT_EQ(table_row("two", host_sim_test::result_without_fits()),
            "two,2,1,1,,,,,,,,,,,,,,,,0,fit,1,\n");
}

TEST(CalibrateTable, SaysWhyACampaignWasRefused) {
  EXPECT_EQ(refused_row("a,b", "x.csv:3: \"y\", z"),
            "\"a,b\",,,,,,,,,,,,,,,,,,,,,,"
            "\"x.csv:3: \"\"y\"\", z\"\n");
}

TEST(CalibrateTable, RowsHaveTheColumnsOfTheHead) {
  const auto commas = [](const std::string& line) {
    return std::count(line.begin(), line.end(), ',');
  };
  EXPECT_EQ(commas(table_head()), 22);
  EXPECT_EQ(commas(table_row("a", host_sim_test::hand_made_result())), 22);
  EXPECT_EQ(commas(refused_row("a", "b")), 22);
}

TEST(CalibrateTable, NamesStayInTheirField) {
  EXPECT_EQ(refused_row("a\nb", "c"), "a\\nb,,,,,,,,,,,,,,,,,,,,,,c\n");
}

}  // namespace
