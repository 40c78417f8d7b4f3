#include "hal/files/text.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>

#include "hal/files/input_error.hpp"

namespace host_sim {

using hal::files::character_count;
using hal::files::in_quotes;
using hal::files::InputError;
using hal::files::other_unit;
using hal::files::parse_number;
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

std::optional<double> whole_number(std::string_view text) {
  const char* position = text.data();
  const char* const end = position + text.size();
  double value = 0.0;
  if (!parse_number(position, end, value) || position != end) {
    return std::nullopt;
  }
  return value;
}

TEST(ParseNumber, ReadsDecimals) {
  EXPECT_EQ(whole_number("38.5"), 38.5);
  EXPECT_EQ(whole_number("+38.5"), 38.5);
  EXPECT_EQ(whole_number("-.5e-3"), -0.0005);
  EXPECT_EQ(whole_number("1."), 1.0);
  EXPECT_EQ(whole_number("1.53E5"), 153000.0);
}

TEST(ParseNumber, RoundsCorrectly) {
  // Just above half way between two doubles, decided by the last of many digits.
  EXPECT_EQ(whole_number("9007199254740993.00000000000000000000000000000000000000001"),
            9007199254740994.0);
  EXPECT_EQ(whole_number("9007199254740993"), 9007199254740992.0);
}

TEST(ParseNumber, RefusesWhatADoubleCannotHold) {
  EXPECT_EQ(whole_number("1e999"), std::nullopt);
  EXPECT_EQ(whole_number("-1e999"), std::nullopt);
  EXPECT_EQ(whole_number("1e-999"), std::nullopt);
}

TEST(ParseNumber, RefusesWhatIsNotANumber) {
  for (const std::string_view text :
       {"+", "-", ".", "e5", "+-1", "-+1", "++1", " 1", "1 ", "0x10", "1,5", "1e", "x", "1_000"}) {
    EXPECT_EQ(whole_number(text), std::nullopt) << text;
  }
}

RC_GTEST_PROP(ParseNumber, ReadsBackEveryDouble, (std::uint64_t bits)) {
  const auto value = std::bit_cast<double>(bits);
  RC_PRE(std::isfinite(value));
  const auto back = whole_number(fmt::format("{:.17g}", value));
  RC_ASSERT(back.has_value());
  RC_ASSERT(std::bit_cast<std::uint64_t>(*back) == bits);
}

RC_GTEST_PROP(ParseNumber, AgreesWithTheCLibrary,
              (std::uint32_t whole, std::uint32_t fraction, std::int8_t exponent)) {
  const std::string text = fmt::format("{}.{}e{}", whole, fraction, int{exponent});
  RC_ASSERT(whole_number(text) == std::strtod(text.c_str(), nullptr));
}

TEST(OtherUnit, FindsTheForeignSuffix) {
  EXPECT_EQ(other_unit("input_tension_kN", "input_tension_N", "N"), "kN");
  EXPECT_EQ(other_unit("tendon_velocity_mm_s", "tendon_velocity_m_s", "m_s"), "mm_s");
  EXPECT_EQ(other_unit("time", "time_s", "s"), "");
  EXPECT_EQ(other_unit("gear_ratio_percent", "gear_ratio", ""), "percent");
}

TEST(OtherUnit, IsNoneForTheNameItselfAndForOtherNames) {
  EXPECT_EQ(other_unit("time_s", "time_s", "s"), std::nullopt);
  EXPECT_EQ(other_unit("timer_s", "time_s", "s"), std::nullopt);
  EXPECT_EQ(other_unit("tim", "time_s", "s"), std::nullopt);
  EXPECT_EQ(other_unit("", "time_s", "s"), std::nullopt);
  EXPECT_EQ(other_unit("time_s;tension_N", "time_s", "s"), std::nullopt);
}

TEST(InputError, SaysPlaceFoundAndAccepted) {
  const InputError error("run.csv", 7, 3, "time_s is 'x'", "a number");
  EXPECT_STREQ(error.what(), "run.csv:7:3: time_s is 'x'; accepted: a number");
  EXPECT_EQ(error.file(), "run.csv");
  EXPECT_EQ(error.line(), 7U);
  EXPECT_EQ(error.column(), 3U);
  EXPECT_EQ(error.found(), "time_s is 'x'");
  EXPECT_EQ(error.accepted(), "a number");
}

TEST(InputError, LeavesOutWhatThereIsNot) {
  EXPECT_STREQ(InputError("f", 7, 0, "a", "b").what(), "f:7: a; accepted: b");
  EXPECT_STREQ(InputError("f", 0, 0, "a", "b").what(), "f: a; accepted: b");
}

TEST(InputError, IsOneLineWhateverTheTexts) {
  const InputError error("a\nb.csv", 1, 2, "found\r\n\x1b[2J", "x\ty");
  EXPECT_STREQ(error.what(), "a\\nb.csv:1:2: found\\r\\n\\x1b[2J; accepted: x\\ty");
}

TEST(InputError, HoldsLinesBeyond32Bits) {
  EXPECT_STREQ(InputError("f", 5'000'000'000, 1, "a", "b").what(),
               "f:5000000000:1: a; accepted: b");
}

}  // namespace

}  // namespace host_sim
