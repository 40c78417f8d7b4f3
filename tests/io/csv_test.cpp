#include "hal/files/csv.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace {

using hal::files::csv_head;
using hal::files::CsvDialect;
using hal::files::CsvLine;
using hal::files::CsvRow;
using hal::files::dialect_of;
using hal::files::finite_number;
using hal::files::no_number;

TEST(CsvDialect, IsThatOfTheHeader) {
  const auto is = [](std::string_view header, char delimiter, bool blanks) {
    const CsvDialect dialect = dialect_of(header);
    return dialect.delimiter == delimiter && dialect.blanks == blanks;
  };
  EXPECT_TRUE(is("a,b", ',', false));
  EXPECT_TRUE(is("a, b", ',', true));
  EXPECT_TRUE(is("a;b", ';', false));
  EXPECT_TRUE(is("a; b,c", ';', true));
  EXPECT_TRUE(is("a\tb; c", '\t', false));
  EXPECT_TRUE(is("a", ',', false));
  EXPECT_TRUE(is("", ',', false));
  EXPECT_TRUE(is("\"a; b\",\"c\td\"", ',', false));
  EXPECT_TRUE(is("\"a, b\";c", ';', false));
}

TEST(CsvDialect, BlanksInFrontOfAFieldArePassedOver) {
  CsvLine line("  1,   \"a, b\",", {',', true});
  ASSERT_TRUE(line.next());
  EXPECT_EQ(line.text(), "1");
  EXPECT_EQ(line.offset(), 2U);
  ASSERT_TRUE(line.next());
  EXPECT_EQ(line.text(), "a, b");
  EXPECT_EQ(line.offset(), 7U);
  ASSERT_TRUE(line.next());
  EXPECT_EQ(line.text(), "");
  EXPECT_FALSE(line.next());
}

TEST(CsvNumber, IsFiniteAndAlone) {
  EXPECT_EQ(finite_number("-1.5e2"), -150);
  for (const char* text : {"", " 1", "1 ", "nan", "inf", "1e999", "1,5", "0x1"}) {
    EXPECT_EQ(finite_number(text), std::nullopt) << text;
  }
  EXPECT_EQ(no_number("", {}).found, "empty");
  EXPECT_EQ(no_number("1,5", {}).found, "'1,5', with a decimal comma");
  EXPECT_EQ(no_number("1.000,5", {}).found, "'1.000,5', not a finite number");
}

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
