#include "hal/files/csv.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace {

using hal::files::csv_head;
using hal::files::CsvRow;

TEST(CsvRow, QuotesWhatAReaderWouldTakeApart) {
  CsvRow row;
  row.add("plain");
  row.add("a,b");
  row.add("say \"x\" and \"y\"");
  row.add("two\nlines");
  row.add("");
  EXPECT_EQ(row.line(), "plain,\"a,b\",\"say \"\"x\"\" and \"\"y\"\"\",two\\nlines,\n");
}

TEST(CsvRow, NumbersReadBackAsTheyWere) {
  CsvRow row;
  row.add(0.1);
  row.add(1.0 / 3);
  row.add(5e-324);
  row.add(std::numeric_limits<double>::infinity());
  row.add(std::numeric_limits<double>::quiet_NaN());
  row.add(18'446'744'073'709'551'615U);
  EXPECT_EQ(row.line(), "0.1,0.3333333333333333,5e-324,inf,,18446744073709551615\n");
}

TEST(CsvRow, FillsUpWithEmptyFields) {
  CsvRow row;
  row.add("name");
  row.fill_to(4);
  row.add("last");
  EXPECT_EQ(row.line(), "name,,,,last\n");
  EXPECT_EQ(csv_head(std::array<std::string_view, 3>{"a", "b", "c"}), "a,b,c\n");
}

}  // namespace
