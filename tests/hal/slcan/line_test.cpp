#include "hal/slcan/line.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace hal::slcan {
namespace {

constexpr CanFrame kShort{0x123, false, 3, {std::byte{0x01}, std::byte{0xAB}, std::byte{0xFF}}};
constexpr CanFrame kLong{0x18DAF101,
                         true,
                         8,
                         {std::byte{0x02}, std::byte{0x3E}, std::byte{0}, std::byte{0xAA},
                          std::byte{0xAA}, std::byte{0xAA}, std::byte{0xAA}, std::byte{0xAA}}};

TEST(FrameLine, IsWhatTheManualPrints) {
  EXPECT_EQ(format({kShort, false}).view(), "t123301ABFF\r");
  EXPECT_EQ(format({kLong, false}).view(), "T18DAF1018023E00AAAAAAAAAA\r");
  EXPECT_EQ(format({{0x001, false, 0, {}}, false}).view(), "t0010\r");
  EXPECT_EQ(format({{0x7ff, false, 8, {}}, true}).view(), "r7FF8\r");
  EXPECT_EQ(format({{0x1fffffff, true, 2, {}}, true}).view(), "R1FFFFFFF2\r");
}

TEST(FrameLine, IsReadInBothCasesOfDigits) {
  EXPECT_EQ(parse_frame("t123301ABFF"), (FrameLine{kShort, false}));
  EXPECT_EQ(parse_frame("t123301abff"), (FrameLine{kShort, false}));
  EXPECT_EQ(parse_frame("T18daf1018023e00aaaaaaaaaa"), (FrameLine{kLong, false}));
  EXPECT_EQ(parse_frame("r7FF8"), (FrameLine{{0x7ff, false, 8, {}}, true}));
  EXPECT_EQ(parse_frame("R000000010"), (FrameLine{{1, true, 0, {}}, true}));
}

class Malformed : public testing::TestWithParam<const char*> {};

TEST_P(Malformed, IsRefused) {
  EXPECT_FALSE(parse_frame(GetParam()).has_value());
}

INSTANTIATE_TEST_SUITE_P(Lines, Malformed,
                         testing::Values("", "t", "t1", "t123", "x1230", "t8000", "tFFF0",
                                         "T200000000", "TFFFFFFFF0", "t1239000000000000000000",
                                         "t123A", "t1231", "t12310", "t1231000", "t12g0", "t 1230",
                                         "t-010", "t123-", "t1231 0", "t12310g", "T123456781",
                                         "T12345678", "r12310", "r1239", "R0000000", "t12300",
                                         "t1230\n", "t12\r0", "T00x000000"));

TEST(FrameLine, EveryIdOfElevenBitsComesBack) {
  for (std::uint32_t id = 0; id <= kHighestStandardId; ++id) {
    const FrameLine line{{id, false, 1, {std::byte{0x5a}}}, false};
    const std::string text(format(line).view());
    EXPECT_EQ(parse_frame(text.substr(0, text.size() - 1)), line);
  }
}

}  // namespace
namespace {

using Event = LineReader::Event;

std::vector<std::string> read(LineReader& reader, std::string_view text) {
  std::vector<std::string> lines;
  for (const char c : text) {
    const Event event = reader.take(static_cast<std::byte>(c));
    if (event == Event::line) {
      lines.emplace_back(reader.line());
    } else if (event == Event::too_long) {
      lines.emplace_back("too long");
    }
  }
  return lines;
}

using Lines = std::vector<std::string>;

TEST(LineReader, EndsALineAtCarriageReturn) {
  LineReader reader;
  EXPECT_EQ(read(reader, "C\rS8\rO"), (Lines{"C", "S8"}));
  EXPECT_EQ(read(reader, "\r\r"), (Lines{"O", ""}));
}

TEST(LineReader, PassesOverLineFeeds) {
  LineReader reader;
  EXPECT_EQ(read(reader, "C\r\nV\r\n"), (Lines{"C", "V"}));
}

TEST(LineReader, TakesTheLongestFrameAndNoMore) {
  const std::string longest(26, 'T');
  LineReader reader;
  EXPECT_EQ(read(reader, longest + "\r"), (Lines{longest}));
  EXPECT_EQ(read(reader, longest + "x\rV\r"), (Lines{"too long", "V"}));
  EXPECT_EQ(read(reader, std::string(100'000, 'x') + "\rN\r"), (Lines{"too long", "N"}));
}

TEST(LineReader, KeepsEveryOtherByteForTheParserToRefuse) {
  LineReader reader;
  EXPECT_EQ(read(reader, std::string_view("t\0\a\xff\r", 5)), (Lines{std::string("t\0\a\xff", 4)}));
}

}  // namespace
}  // namespace hal::slcan
