#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "hal/slcan/line.hpp"

namespace hal::slcan {
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
