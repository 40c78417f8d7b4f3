#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>

#include "hal/files/text.hpp"

namespace host_sim {

using hal::files::character_count;
using hal::files::in_quotes;
using hal::files::printable;

namespace {

using std::string_literals::operator""s;

TEST(Printable, LeavesTextAlone) {
  EXPECT_EQ(printable("Zug am Ärmel, 38.5 N → 270°"), "Zug am Ärmel, 38.5 N → 270°");
}

TEST(Printable, EscapesControlCharacters) {
  EXPECT_EQ(printable("a\nb\rc\td\0e\x1b[31m\x7f"s), "a\\nb\\rc\\td\\x00e\\x1b[31m\\x7f");
}

TEST(Printable, EscapesWhatHidesOrTurnsText) {
  EXPECT_EQ(printable("\u0085"), "\\xc2\\x85");       // next line
  EXPECT_EQ(printable("\u202E"), "\\xe2\\x80\\xae");  // right-to-left override
  EXPECT_EQ(printable("\u2028"), "\\xe2\\x80\\xa8");  // line separator
  EXPECT_EQ(printable("\uFEFF"), "\\xef\\xbb\\xbf");  // byte order mark
}

TEST(Printable, EscapesWhatIsNotUtf8) {
  EXPECT_EQ(printable("\xb0"), "\\xb0");                    // Latin-1
  EXPECT_EQ(printable("\xc3"), "\\xc3");                    // cut short
  EXPECT_EQ(printable("\xc0\xaf"), "\\xc0\\xaf");           // overlong
  EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80");  // surrogate
  EXPECT_EQ(printable("\xf5\x80\x80\x80"), "\\xf5\\x80\\x80\\x80");
}

TEST(Printable, ClipsByCharacters) {
  EXPECT_EQ(printable("äöüß", 3), "äöü...");
  EXPECT_EQ(printable("äöü", 3), "äöü");
}

TEST(InQuotes, ClipsLongValues) {
  EXPECT_EQ(in_quotes("1.5"), "'1.5'");
  EXPECT_EQ(in_quotes(std::string(41, '7')), "'" + std::string(40, '7') + "...'");
}

TEST(CharacterCount, CountsCharactersAndStrayBytes) {
  EXPECT_EQ(character_count(""), 0U);
  EXPECT_EQ(character_count("a°→"), 3U);
  EXPECT_EQ(character_count("\xb0\xb0"), 2U);
}

RC_GTEST_PROP(Printable, NeverLetsAControlCharacterThrough, (const std::string& text)) {
  for (const char c : printable(text)) {
    RC_ASSERT(static_cast<unsigned char>(c) >= 0x20);
    RC_ASSERT(c != '\x7f');
  }
}

RC_GTEST_PROP(Printable, IsPrintableAlready, (const std::string& text)) {
  RC_ASSERT(printable(printable(text)) == printable(text));
}

}  // namespace
}  // namespace host_sim
