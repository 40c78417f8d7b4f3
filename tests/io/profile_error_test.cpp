#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "hal/files/column_map.hpp"
#include "hal/files/profile.hpp"
#include "tests/io/support.hpp"

namespace host_sim {

using hal::files::InputKind;
using hal::files::ProfileOptions;
using hal::files::ProfileReader;

namespace {

using std::string_literals::operator""s;
using test::profile_complaint;

constexpr std::string_view kNumber = "a finite decimal number without spaces";
constexpr std::string_view kColumns =
    "time_s, input_tension_N, motor_current_A, output_tension_N, tendon_velocity_m_s, "
    "bend_angle_deg, motor_angle_rad, sheath_temperature_C, winding_temperature_C";
constexpr std::string_view kNeeded =
    "time_s and one of input_tension_N, motor_current_A, output_tension_N with "
    "tendon_velocity_m_s";

struct BadProfile {
  std::string name;
  std::string text;
  std::string place_and_found;
  std::string_view accepted;
  ProfileOptions options{};
};

void PrintTo(const BadProfile& bad, std::ostream* out) {
  *out << bad.name;
}

class BadProfiles : public testing::TestWithParam<BadProfile> {};

TEST_P(BadProfiles, AreRefusedWithPlaceFoundAndAccepted) {
  const BadProfile& bad = GetParam();
  EXPECT_EQ(profile_complaint(bad.text, bad.options),
            "p.csv" + bad.place_and_found + "; accepted: " + std::string(bad.accepted));
}

std::vector<BadProfile> bad_headers() {
  return {
      {"OnlyByteOrderMark", "\xEF\xBB\xBF", ":1:1: an empty line in place of the header", kNeeded},
      {"BlankFirstLine", "\ntime_s,input_tension_N\n0,1\n",
       ":1:1: an empty line in place of the header", kNeeded},
      {"UnknownColumn", "time_s,force,input_tension_N\n0,1,2\n", ":1:8: unknown column 'force'",
       kColumns},
      {"OtherUnit", "time_s,input_tension_kN\n0,1\n",
       ":1:8: other unit 'kN' of column 'input_tension_kN'", "input_tension_N"},
      {"OtherUnitOfTime", "time_ms,input_tension_N\n0,1\n",
       ":1:1: other unit 'ms' of column 'time_ms'", "time_s"},
      {"OtherUnitOfVelocity", "time_s,output_tension_N,tendon_velocity_mm_s\n0,1,1\n",
       ":1:25: other unit 'mm_s' of column 'tendon_velocity_mm_s'", "tendon_velocity_m_s"},
      {"UnknownUnit", "time_fortnights,input_tension_N\n0,1\n",
       ":1:1: unknown unit 'fortnights' of column 'time_fortnights'", "time_s"},
      {"Misspelt", "time_s,input_tenison_N\n0,1\n",
       ":1:8: unknown column 'input_tenison_N', nearest to input_tension_N", kColumns},
      {"IndexOfPandas", ",time_s,input_tension_N\n0,0,1\n",
       ":1:1: column '', as pandas writes the index of its rows", "to_csv(index=False) in pandas"},
      {"IndexOfPandasReadAgain", "Unnamed: 0,time_s,input_tension_N\n0,0,1\n",
       ":1:1: column 'Unnamed: 0', as pandas writes the index of its rows",
       "to_csv(index=False) in pandas"},
      {"NoUnit", "time,input_tension_N\n0,1\n", ":1:1: column 'time' without its unit", "time_s"},
      {"EmptyName", "time_s,input_tension_N,\n0,1,\n", ":1:24: unknown column ''", kColumns},
      {"NoHeader", "0,1\n1,2\n", ":1:1: unknown column '0'", kColumns},
      {"OldMacLineEnds", "time_s,input_tension_N\r0,1\r",
       ":1:8: unknown column 'input_tension_N\\r0', nearest to input_tension_N", kColumns},
      {"Twice", "# c\ntime_s,input_tension_N,time_s\n0,1,2\n", ":2:24: column time_s a second time",
       "each column once"},
      {"NoTime", "input_tension_N\n1\n", ":1:16: no column time_s", kNeeded},
      {"NoLoad", "time_s,bend_angle_deg\n0,1\n", ":1:22: no column of tension or current", kNeeded},
      {"NoVelocity", "time_s,output_tension_N\n0,1\n", ":1:24: no column tendon_velocity_m_s",
       kNeeded},
      {"NoCurrentWhereAskedFor",
       "time_s,input_tension_N\n0,1\n",
       ":1:23: no column motor_current_A",
       kNeeded,
       {InputKind::kMotorCurrent}},
      {"NoVelocityWhereAskedFor",
       "time_s,input_tension_N,output_tension_N\n0,1,2\n",
       ":1:40: no column tendon_velocity_m_s",
       kNeeded,
       {InputKind::kOutputTension}},
      {"OpenQuote", "time_s,\"input_tension_N\n0,1\n",
       ":1:8: a quoted name that does not end with its quote", kColumns},
      {"NulInHeader", "time_s,input\0_tension_N\n0,1\n"s, ":1:13: a NUL byte", "UTF-8 text"},
      {"Utf16", "t\0i\0m\0e\0"s, ":1:2: a NUL byte", "UTF-8 text"},
      {"NotAscii", "\"\u00e4\u00f6\u00fc\",time_s\n0,1\n",
       ":1:1: unknown column '\u00e4\u00f6\u00fc'", kColumns},
      {"EscapeSequence", "time_s,\x1b[2Jx\n0,1\n", ":1:8: unknown column '\\x1b[2Jx'", kColumns},
      {"Empty", "", ": the file is empty",
       "a CSV file with time_s and one of input_tension_N, motor_current_A, output_tension_N with "
       "tendon_velocity_m_s, or - for standard input"},
      {"NoRows", "time_s,input_tension_N\n# nothing\n", ": no rows",
       "at least one row after the header"},
  };
}

std::vector<BadProfile> bad_rows() {
  const std::string head = "time_s,input_tension_N\n0,1\n";
  const std::string out = "time_s,output_tension_N,tendon_velocity_m_s,bend_angle_deg\n";
  const auto tension = [&](std::string name, std::string_view value, std::string_view shown) {
    return BadProfile{std::move(name), head + "1," + std::string(value) + "\n",
                      ":3:3: input_tension_N is " + std::string(shown), kNumber};
  };
  return {
      tension("Nan", "nan", "'nan', not a finite number"),
      tension("NanUpper", "NaN", "'NaN', not a finite number"),
      tension("NegativeNan", "-nan", "'-nan', not a finite number"),
      tension("Infinity", "inf", "'inf', not a finite number"),
      tension("NegativeInfinity", "-Infinity", "'-Infinity', not a finite number"),
      tension("TooLarge", "1e999", "'1e999', not a finite number"),
      tension("Garbage", "abc", "'abc', not a finite number"),
      tension("NumberWithTail", "1.5N", "'1.5N', not a finite number"),
      tension("Hexadecimal", "0x1F", "'0x1F', not a finite number"),
      tension("SpaceBefore", " 2", "' 2', not a finite number"),
      tension("SpaceAfter", "2 ", "'2 ', not a finite number"),
      tension("Empty", "", "empty"),
      tension("EmptyQuotes", "\"\"", "empty"),
      tension("OpenQuote", "\"2", "quoted, but the field does not end with its quote"),
      tension("TextAfterQuote", "\"2\"5", "quoted, but the field does not end with its quote"),
      tension("QuoteInQuotes", "\"2\"\"\"", "'2\"', not a finite number"),
      tension("LoneReturn", "2\r3", "'2\\r3', not a finite number"),
      tension("TwoReturns", "2\r\r", "'2\\r', not a finite number"),
      tension("Long", std::string(50, '7') + "x",
              "'" + std::string(40, '7') + "...', not a finite number"),
      {"Nul", head + "1,2\0\n"s, ":3:4: a NUL byte", "UTF-8 text"},
      {"CountsCharacters", head + "# \u00e4\u00f6\0\n"s, ":3:5: a NUL byte", "UTF-8 text"},
      {"NulInComment", head + "# a\0b\n"s, ":3:4: a NUL byte", "UTF-8 text"},
      {"NotANumberOfTime", head + "x,2\n", ":3:1: time_s is 'x', not a finite number", kNumber},
      {"UnneededColumnIsChecked", "time_s,input_tension_N,motor_angle_rad\n0,1,2\n1,2,nan\n",
       ":3:5: motor_angle_rad is 'nan', not a finite number", kNumber},
      {"UnneededKindIsChecked", "time_s,input_tension_N,motor_current_A\n0,1,\n",
       ":2:5: motor_current_A is empty", kNumber},
      {"TensionOutOfRange", head + "1,1000001\n",
       ":3:3: input_tension_N is '1000001', out of range", "-1000000..1000000 N"},
      {"CurrentOutOfRange", "time_s,motor_current_A\n0,-1e7\n",
       ":2:3: motor_current_A is '-1e7', out of range", "-1000000..1000000 A"},
      {"BendNegative", out + "0,1,0,-1\n", ":2:7: bend_angle_deg is '-1', out of range",
       "0..1800 deg"},
      {"BendTooLarge", out + "0,1,0,1800.5\n", ":2:7: bend_angle_deg is '1800.5', out of range",
       "0..1800 deg"},
      {"VelocityOutOfRange", out + "0,1,1001,0\n",
       ":2:5: tendon_velocity_m_s is '1001', out of range", "-1000..1000 m_s"},
      {"TimeBack", head + "1,2\n0.5,3\n", ":4:1: time runs back from 1 s to 0.5 s",
       "time that increases from row to row"},
      {"TimeStill", head + "0,2\n", ":3:1: time stands still at 0 s",
       "time that increases from row to row"},
      {"TimeNotFirstColumn", "input_tension_N,time_s\n1,5\n1,4\n",
       ":3:3: time runs back from 5 s to 4 s", "time that increases from row to row"},
      {"TooFew", head + "1\n", ":3:2: 1 fields only", "2 fields, as in the header"},
      {"CutOff", head + "1", ":3:2: 1 fields only", "2 fields, as in the header"},
      {"CutOffBeforeField", head + "1,", ":3:3: input_tension_N is empty", kNumber},
      {"TooMany", head + "1,2,3\n", ":3:5: more fields than the header",
       "2 fields, as in the header"},
      {"TooManyEmpty", head + "1,2,\n", ":3:5: more fields than the header",
       "2 fields, as in the header"},
      {"BlankLine", head + "\n1,2\n", ":3:1: an empty line", "2 fields, as in the header"},
      {"BlankLineAtEnd", head + "\r\n", ":3:1: an empty line", "2 fields, as in the header"},
      {"AfterComments", head + "# \u00e4\n\n", ":4:1: an empty line", "2 fields, as in the header"},
      {"DecimalComma", head + "\"1,5\",2\n", ":3:1: time_s is '1,5', with a decimal comma",
       "decimal points, '1.5': write the file anew with them"},
      {"DecimalCommaBetweenSemicolons", "time_s;input_tension_N\n0;-1,5e2\n",
       ":2:3: input_tension_N is '-1,5e2', with a decimal comma",
       "decimal points, '-1.5e2': sed 's/,/./g' FILE writes them"},
      {"DecimalCommasBetweenCommas", "time_s,input_tension_N\n0,0,38,5\n",
       ":2:5: 4 fields, as decimal commas make them of 2",
       "decimal points, or fields between semicolons or tabs"},
  };
}

/// With options that a command line can give.
ProfileOptions given(std::vector<std::string> maps, bool ignore_extra = false) {
  ProfileOptions options;
  for (const std::string& map : maps) {
    options.columns.maps.push_back(hal::files::column_map(map));
  }
  options.columns.ignore_extra = ignore_extra;
  options.columns.given_by_options = true;
  return options;
}

std::vector<BadProfile> bad_columns() {
  const std::string columns(kColumns);
  static const std::string unknown =
      columns + "; --column force=COLUMN, or --ignore-extra to pass it over";
  static const std::string misspelt =
      columns + "; --column tmie_s=time_s, or --ignore-extra to pass it over";
  static const std::string worded =
      columns + "; --column '\"load cell\"=COLUMN', or --ignore-extra to pass it over";
  return {
      {"Unknown", "time_s,force\n0,1\n", ":1:8: unknown column 'force'", unknown, given({})},
      {"Misspelt", "tmie_s,input_tension_N\n0,1\n",
       ":1:1: unknown column 'tmie_s', nearest to time_s", misspelt, given({})},
      {"Words", "time_s,load cell\n0,1\n", ":1:8: unknown column 'load cell'", worded, given({})},
      {"OtherUnit", "time_s,input_tension_kN\n0,1\n",
       ":1:8: other unit 'kN' of column 'input_tension_kN'",
       "input_tension_N; --column 'input_tension_kN in kN=input_tension_N', or --ignore-extra to "
       "pass it over",
       given({})},
      {"NoUnit", "time,input_tension_N\n0,1\n", ":1:1: column 'time' without its unit",
       "time_s; --column time=time_s, or --ignore-extra to pass it over", given({})},
      {"IndexOfPandas", ",time_s,input_tension_N\n0,0,1\n",
       ":1:1: column '', as pandas writes the index of its rows",
       "--ignore-extra, or to_csv(index=False) in pandas", given({})},
      {"MapOfNoColumn", "t,load\n0,1\n", ":1:1: no column 'laod' for input_tension_N", "load",
       given({"t=time_s", "laod=input_tension_N"})},
      {"MapOfNothingLikeIt", "t,load\n0,1\n", ":1:1: no column 'x' for input_tension_N",
       "one of t, load", given({"t=time_s", "x=input_tension_N"})},
      {"ByNameAndByMap", "time_s,input_tension_N,f\n0,1,2\n",
       ":1:8: column input_tension_N a second time", "each column once",
       given({"f=input_tension_N"})},
      {"ExtraTwice", "time_s,time_s,input_tension_N\n0,1,2\n", ":1:8: column time_s a second time",
       "each column once", given({}, true)},
      {"Mapped", "t,F\n0,1\n1,x\n", ":3:3: F is 'x', not a finite number", kNumber,
       given({"t=time_s", "F=input_tension_N"})},
      {"MappedOutOfRange", "t,F\n0,1\n1,2e3\n",
       ":3:3: F is '2e3', and input_tension_N becomes 2000000, out of range", "-1000000..1000000 N",
       given({"t=time_s", "F in kN=input_tension_N"})},
      {"MappedTimeBack", "t,input_tension_N\n2000,1\n1000,2\n",
       ":3:1: time runs back from 2 s to 1 s", "time that increases from row to row",
       given({"t in ms=time_s"})},
      {"OpenQuoteInExtra", "time_s,note,input_tension_N\n0,\"a,1\n",
       ":2:3: note is quoted, but the field does not end with its quote",
       "a field with both quotes, or without", given({}, true)},
      {"NulInExtra", "time_s,note,input_tension_N\n0,a\0b,1\n"s, ":2:4: a NUL byte", "UTF-8 text",
       given({}, true)},
      {"TooFewWithExtra", "time_s,input_tension_N,note\n0,1\n", ":2:4: 2 fields only",
       "3 fields, as in the header", given({}, true)},
      {"ColumnBehindBlanks", "time_s, input_tension_N\n0,  x\n",
       ":2:5: input_tension_N is 'x', not a finite number", kNumber},
      {"BlankBetweenCommasWithoutOne", "time_s,input_tension_N\n0, 1\n",
       ":2:3: input_tension_N is ' 1', not a finite number", kNumber},
  };
}

std::string name_of(const testing::TestParamInfo<BadProfile>& info) {
  return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(Header, BadProfiles, testing::ValuesIn(bad_headers()), name_of);
INSTANTIATE_TEST_SUITE_P(Columns, BadProfiles, testing::ValuesIn(bad_columns()), name_of);
INSTANTIATE_TEST_SUITE_P(Row, BadProfiles, testing::ValuesIn(bad_rows()), name_of);

std::string opening_complaint(const std::filesystem::path& path) {
  return test::complaint_of([&] { const ProfileReader reader(path); });
}

TEST(ProfileFile, RefusesAMissingFile) {
  const test::TemporaryFolder folder;
  const std::string path = (folder / "none.csv").string();
  EXPECT_EQ(opening_complaint(path).rfind(
                path + ": cannot be opened: No such file or directory; accepted: a CSV file", 0),
            0U);
}

TEST(ProfileFile, RefusesADirectory) {
  const test::TemporaryFolder folder;
  const std::string path = (folder / "").string();
  EXPECT_EQ(opening_complaint(path).rfind(path + ": is a directory; accepted: a CSV file", 0), 0U);
}

TEST(ProfileFile, RefusesAnUnreadableFile) {
  const test::TemporaryFolder folder;
  const test::WithoutPrivileges nobody;
  const auto path = folder / "secret.csv";
  test::write_text(path, "time_s,input_tension_N\n0,1\n");
  std::filesystem::permissions(path, std::filesystem::perms::none);
  EXPECT_NE(opening_complaint(path).find("cannot be opened: Permission denied"), std::string::npos);
}

// Reading a process's own memory at address 0 fails, for root too.
TEST(ProfileFile, ReportsAReadThatFails) {
  EXPECT_EQ(opening_complaint("/proc/self/mem")
                .rfind("/proc/self/mem: cannot be read: Input/output error; accepted: ", 0),
            0U);
}

TEST(ProfileFile, ReportsTheNumberOfALineFarDown) {
  std::string text = "time_s,input_tension_N\n";
  for (int i = 0; i < 200'000; ++i) {
    text += std::to_string(i) + ",1\n";
  }
  EXPECT_EQ(profile_complaint(text + "200000,x\n").rfind("p.csv:200002:8: ", 0), 0U);
}

TEST(ProfileFile, LimitsTheLengthOfALine) {
  const std::string head = "time_s,input_tension_N\n0,1\n#";
  const std::size_t limit = std::size_t{1} << 20;
  EXPECT_EQ(profile_complaint(head + std::string(limit - 2, 'c') + "\n1,2\n"), "");
  EXPECT_EQ(profile_complaint(head + std::string(limit - 1, 'c') + "\n1,2\n"),
            "p.csv:3: a line that does not end; accepted: lines of at most 1 MiB");
}

}  // namespace
}  // namespace host_sim
