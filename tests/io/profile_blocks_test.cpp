#include "hal/files/profile_blocks.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "by_the_book.hpp"
#include "support.hpp"

namespace host_sim {

using hal::files::InputError;
using hal::files::ProfileBlocks;
using hal::files::ProfileReader;

namespace {

using test::agree;
using test::read_by_the_book;
using test::read_profile;
using test::ReadProfile;
using test::same_bits;

constexpr unsigned kThreads = 4;
constexpr std::size_t kWhole = std::size_t{1} << 30;

const std::string kOfEachKind =
    "\xEF\xBB\xBF# first\r\ntime_s,output_tension_N,tendon_velocity_m_s,bend_angle_deg\r\n"
    "-1.5,38.5,0.1,270\r\n# between, 1,2\r\n0,+38.25,-0.1,270.0\n1e-3,\"38\",-0,1.8e2\n"
    "0.0020000000000000001,38.123456789012345,.5,5.\n\"3\",\"4.25\",\"0.5\",\"0\"\r\n"
    "12345678.12345678,1e5,-1000,1800\n123456789012.5,0.000000000000000001,0,0\n#\n"
    "999999999999,12,3,4";

TEST(ProfileBlocks, WhereverAFileIsCutItsRowsAreThoseByTheBook) {
  const ReadProfile book = read_by_the_book(kOfEachKind, {});
  ASSERT_EQ(book.error, "");
  ASSERT_EQ(book.rows.size(), 8U);
  for (unsigned threads = 1; threads <= kThreads; ++threads) {
    for (std::size_t cut = 1; cut <= kOfEachKind.size(); ++cut) {
      const ReadProfile read = read_profile(kOfEachKind, {cut, kWhole}, {{}, threads});
      ASSERT_TRUE(same_bits(read, book)) << threads << " threads, cut at " << cut << read.error;
      ASSERT_TRUE(same_bits(read_profile(kOfEachKind, {cut}, {{}, threads}), book)) << cut;
    }
  }
}

TEST(ProfileBlocks, WhereverAFileIsCutItsErrorIsThatByTheBook) {
  using std::string_literals::operator""s;
  for (const std::string& row : {"999999999999,12,3,4"s,
                                 "9,1,2,3"s,
                                 "1e12,1,2"s,
                                 "1e12,1,2,3,4"s,
                                 "1e12,1,2,\"3"s,
                                 "1e12,1,2,3x"s,
                                 "1e12,1,nan,3"s,
                                 "1e12,1,2,-1"s,
                                 ""s,
                                 "1e12,1,2,1e400"s,
                                 "# \0"s,
                                 "1e12,\0,2,3"s,
                                 "1e12, 1,2,3"s,
                                 "1e12,1,2,3 "s,
                                 "1e12,1,2,1\"2"s,
                                 "1e12,1,2,--3"s,
                                 "1e12,1,2,1e"s,
                                 "1e12,1.2.3,2,3"s,
                                 "1e12,0x1,2,3"s,
                                 "1e12,1,2,12345678901234567890x"s}) {
    const std::string text = kOfEachKind + "\n" + row + "\n1e12,1,2,3\n";
    const ReadProfile book = read_by_the_book(text, {});
    ASSERT_NE(book.error.find("p.csv:13:"), std::string::npos) << row << ": " << book.error;
    for (unsigned threads = 1; threads <= kThreads; ++threads) {
      for (std::size_t cut = 1; cut <= text.size(); ++cut) {
        const ReadProfile read = read_profile(text, {cut, kWhole}, {{}, threads});
        ASSERT_TRUE(agree(read, book)) << read.error << " for " << book.error << ", cut at " << cut;
      }
      ASSERT_TRUE(agree(read_profile(text, {3}, {{}, threads}), book)) << book.error;
    }
  }
}

/// What other programs write: any delimiter, blanks, columns of other names and units, and columns
/// that are passed over.
TEST(ProfileBlocks, WhateverTheDialectRowsAndErrorsAreThoseByTheBook) {
  using std::string_literals::operator""s;
  hal::files::ColumnOptions columns;
  columns.maps.push_back(hal::files::column_map("t in ms=time_s"));
  columns.maps.push_back(hal::files::column_map("-0.5*F+3=input_tension_N"));
  columns.ignore_extra = true;
  for (const std::string& between : {","s, ";"s, "\t"s, ", "s, ";  "s}) {
    std::string text =
        "|t|note|F|\n0|0|a b|-74|x\n1|1e3|\"c\"|-74.5|\r\n2|\"2000\"|3\"|+1|\n"
        "3|3000||1.5|#\n";
    for (std::size_t at = text.find('|'); at != std::string::npos; at = text.find('|', at + 1)) {
      text.replace(at, 1, between);
    }
    const ReadProfile book = read_by_the_book(text, {{}, 1, columns});
    ASSERT_EQ(book.error, "") << between;
    ASSERT_EQ(book.rows.size(), 4U);
    EXPECT_EQ(book.rows[1].time_s, 1);
    EXPECT_EQ(book.rows[1].value, 40.25);  // -0.5 * -74.5 + 3
    EXPECT_EQ(book.rows[3].value, 2.25);
    for (const std::string& end :
         {""s, "4|x|a|1|\n"s, "4|4000|a|1,5|\n"s, "4|4000|a|1\n"s, "4|1|a|1|\n"s, "4|4000|\"|1|\n"s,
          "4|4000|a\rb|1|\n"s, "4|4000|a\0|1|\n"s, "4|4000|a|3e6|\n"s, "4|4000|a|1|b|\n"s}) {
      std::string longer = text + end;
      for (std::size_t at = longer.find('|'); at != std::string::npos;
           at = longer.find('|', at + 1)) {
        longer.replace(at, 1, between);
      }
      const ReadProfile slow = read_by_the_book(longer, {{}, 1, columns});
      for (std::size_t cut = 1; cut <= longer.size(); ++cut) {
        const ReadProfile fast =
            read_profile(longer, {cut, kWhole}, {{}, static_cast<unsigned>(1 + cut % 3), columns});
        ASSERT_TRUE(agree(fast, slow)) << longer << fast.error << " for " << slow.error;
      }
    }
  }
}

/// As recorders write numbers, and as nobody does.
std::string any_number(double value) {
  const int digits = *rc::gen::inRange(0, 18);
  switch (*rc::gen::inRange(0, 8)) {
    case 0:
      return fmt::format("{}", value);
    case 1:
      return fmt::format("{:e}", value);
    case 2:
      return fmt::format("+{:.{}f}", std::fabs(value), digits);
    case 3:
      return fmt::format("\"{:.{}f}\"", value, digits);
    case 4:
      return *rc::gen::element<std::string>("", "-", ".", "1.", ".5", "-.5", "00012.50", "1e3",
                                            "x");
    default:
      return fmt::format("{:.{}f}", value, digits);
  }
}

RC_GTEST_PROP(ProfileBlocks, AnyProfileInAnyPiecesIsThatByTheBook, ()) {
  std::string text = "time_s,input_tension_N\n";
  double time_s = *rc::gen::inRange(-1000, 1000) / 7.0;
  for (int rows = *rc::gen::inRange(1, 60); rows > 0; --rows) {
    text += *rc::gen::element("", "", "", "# comment\n", "#\r\n");
    text += *rc::gen::element(0, 1, 2, 3) == 0 ? any_number(time_s) : fmt::format("{}", time_s);
    text += "," + any_number(*rc::gen::inRange(-1'000'000, 1'000'000) / 3.0);
    text += *rc::gen::element("\n", "\n", "\r\n");
    time_s += *rc::gen::inRange(1, 1000) / 13.0;
  }
  const auto pieces =
      *rc::gen::nonEmpty(rc::gen::container<std::vector<std::size_t>>(rc::gen::inRange(1, 200)));
  const unsigned threads = *rc::gen::inRange(1U, kThreads + 1);
  RC_ASSERT(agree(read_profile(text, pieces, {{}, threads}), read_by_the_book(text, {})));
}

/// `rows` of 19 bytes from line 2 on: many windows.
std::string long_profile(int rows) {
  std::string text = "time_s,input_tension_N\n";
  for (int i = 0; i < rows; ++i) {
    text += fmt::format("{:010.3f},{:.4f}\n", i * 1e-3, 50 + 30 * std::sin(i * 0.01));
  }
  return text;
}

TEST(ProfileBlocks, ALongFileIsThatByTheBookForAnyNumberOfThreads) {
  const std::string text = long_profile(100'000);
  ASSERT_GT(text.size(), 10 * ProfileBlocks::kWindow);
  const ReadProfile book = read_by_the_book(text, {});
  ASSERT_EQ(book.rows.back().line, 100'001U);
  for (unsigned threads = 1; threads <= kThreads; ++threads) {
    EXPECT_TRUE(same_bits(read_profile(text, {kWhole}, {{}, threads}), book)) << threads;
  }
}

TEST(ProfileBlocks, AnErrorFarInSaysItsLine) {
  const std::string text = long_profile(100'000);
  for (unsigned threads = 1; threads <= kThreads; ++threads) {
    const auto error_of = [&, threads](const std::string& end) {
      return read_profile(text + end, {kWhole}, {{}, threads}).error;
    };
    EXPECT_EQ(error_of("100,1x\n101,2\n"),
              "p.csv:100002:5: input_tension_N is '1x', not a finite number; accepted: a finite "
              "decimal number without spaces");
    EXPECT_EQ(error_of("50,1\n"),
              "p.csv:100002:1: time runs back from 99.999 s to 50 s; accepted: time that increases "
              "from row to row");
    EXPECT_EQ(error_of("100,1\n#" + std::string(std::size_t{1} << 20, '-')),
              "p.csv:100003: a line that does not end; accepted: lines of at most 1 MiB");
  }
}

/// A row in front of others is refused, also where threads have read far ahead of it.
TEST(ProfileBlocks, TheFirstErrorOfManyIsTheOne) {
  const std::string text = "time_s,input_tension_N\n0,1\n-1,2\n" + long_profile(30'000) + "x\n";
  for (unsigned threads = 1; threads <= kThreads; ++threads) {
    EXPECT_EQ(
        read_profile(text, {kWhole}, {{}, threads}).error,
        "p.csv:3:1: time runs back from 0 s to -1 s; accepted: time that increases from row to "
        "row");
  }
}

/// Nobody waits for what a stream has not given yet.
TEST(ProfileBlocks, AStreamIsReadAsItComes) {
  const test::TemporaryFolder folder;
  const std::string path = folder / "stream";
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  std::ofstream out;
  std::thread opener([&] {
    out.open(path);
    out << "time_s,input_tension_N\n0,1\n" << std::flush;
  });
  ProfileReader reader(path, {{}, kThreads});
  opener.join();
  ASSERT_EQ(reader.read_block().size(), 1U);
  for (int i = 1; i < 100; ++i) {
    out << i << ",2\n" << std::flush;
    const auto rows = reader.read_block();
    ASSERT_EQ(rows.size(), 1U);
    EXPECT_EQ(rows.front().time_s, i);
    EXPECT_EQ(rows.front().line, static_cast<std::uint64_t>(i) + 2);
  }
  out << "100,x\n" << std::flush;
  EXPECT_THROW(static_cast<void>(reader.read_block()), InputError);
}

}  // namespace
}  // namespace host_sim
