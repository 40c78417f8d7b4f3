#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "host_sim/campaign/specimens_file.hpp"
#include "tests/campaign/support.hpp"

namespace host_sim {
namespace {

using test::replaced;

constexpr std::string_view kGood =
    "specimen,lot,bend_angle_deg,output_tension_mean_N,output_tension_amplitude_N,cycles,status,"
    "role,days,wire_to_bend_ratio,group,input_tension_mean_N,input_tension_amplitude_N\n"
    "a,L1,315,49.0,0,854,failed,fit,12.5,0.02,red,,\n"
    "b,L1,270,38.5,10,1000.5,suspended,validation,,,,,\n"
    "c,L2,,,,500,failed,,0,,,25,24.5\n";

std::vector<SpecimenRow> rows_of(std::string_view text) {
  return parse_specimens(memory_source(text), "s.csv");
}

std::string complaint(std::string_view text) {
  return test::complaint_of([&] { rows_of(text); });
}

TEST(Specimens, ReadsEveryCell) {
  const std::vector<SpecimenRow> rows = rows_of(kGood);
  ASSERT_EQ(rows.size(), 3U);
  const Campaign::Specimen& a = rows[0].specimen;
  EXPECT_EQ(a.name, "a");
  EXPECT_EQ(a.lot, "L1");
  EXPECT_EQ(a.group, "red");
  EXPECT_EQ(a.status, Campaign::Status::failed);
  EXPECT_EQ(a.role, Campaign::Role::fit);
  EXPECT_EQ(a.line, 2U);
  ASSERT_TRUE(a.days.has_value());
  EXPECT_EQ(*a.days, 12.5);
  ASSERT_TRUE(a.wire_to_bend_ratio.has_value());
  EXPECT_EQ(*a.wire_to_bend_ratio, 0.02);
  EXPECT_EQ(rows[0].cycles, 854.0);
  EXPECT_EQ(rows[0].load.kind(), LoadKind::output_tension);
  EXPECT_EQ(rows[0].load.value(kBendAngleKey), 315.0);
  EXPECT_EQ(rows[0].load.value(kOutputMeanKey), 49.0);
  EXPECT_EQ(rows[0].load.value(kOutputAmplitudeKey), 0.0);
  const Campaign::Specimen& b = rows[1].specimen;
  EXPECT_EQ(b.group, "");
  EXPECT_EQ(b.status, Campaign::Status::suspended);
  EXPECT_EQ(b.role, Campaign::Role::validation);
  EXPECT_FALSE(b.days.has_value());
  EXPECT_FALSE(b.wire_to_bend_ratio.has_value());
  EXPECT_EQ(rows[1].cycles, 1000.5);
  const Campaign::Specimen& c = rows[2].specimen;
  EXPECT_EQ(c.role, Campaign::Role::fit);
  EXPECT_EQ(c.lot, "L2");
  EXPECT_EQ(rows[2].load.kind(), LoadKind::input_tension);
  EXPECT_EQ(rows[2].load.value(kInputMeanKey), 25.0);
  EXPECT_EQ(rows[2].load.value(kInputAmplitudeKey), 24.5);
}

TEST(Specimens, AcceptsQuotesLineEndsCommentsAndByteOrderMark) {
  const auto rows = rows_of(
      "\xEF\xBB\xBF# tested, \"on\" a Monday\r\n"
      "\"specimen\",lot,cycles,status\r\n"
      "# a, b\n"
      "\"a,\"\"1\"\"\",,+8.54e2,failed\r\n"
      "b,\"\",1,suspended");
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].specimen.name, "a,\"1\"");
  EXPECT_EQ(rows[0].specimen.line, 4U);
  EXPECT_EQ(rows[0].cycles, 854.0);
  EXPECT_EQ(rows[0].load.kind(), LoadKind::none);
  EXPECT_EQ(rows[1].specimen.lot, "");
}

struct BadTable {
  std::string name;
  std::string_view from;
  std::string_view to;
  std::string complaint;
};

void PrintTo(const BadTable& bad, std::ostream* out) {
  *out << bad.name;
}

class BadSpecimens : public testing::TestWithParam<BadTable> {};

TEST_P(BadSpecimens, AreRefusedWithPlaceFoundAndAccepted) {
  const BadTable& bad = GetParam();
  EXPECT_EQ(complaint(replaced(kGood, bad.from, bad.to)), "s.csv" + bad.complaint);
}

const std::string kColumns =
    "bend_angle_deg, output_tension_mean_N, output_tension_amplitude_N, input_tension_mean_N, "
    "input_tension_amplitude_N, specimen, lot, cycles, status, days, wire_to_bend_ratio, group, "
    "role";
const std::string kLoad =
    "bend_angle_deg with output_tension_mean_N and output_tension_amplitude_N, or "
    "input_tension_mean_N with input_tension_amplitude_N";
const std::string kNumber = "a finite decimal number without spaces";

const std::vector<BadTable> kBadTables{
    {"UnknownColumn", "group", "colour", ":1:121: unknown column 'colour'; accepted: " + kColumns},
    {"OtherUnit", "bend_angle_deg", "bend_angle_rad",
     ":1:14: unknown unit 'rad' of column 'bend_angle_rad'; accepted: bend_angle_deg"},
    {"NoUnit", "output_tension_mean_N", "output_tension_mean",
     ":1:29: column 'output_tension_mean' without its unit; accepted: output_tension_mean_N"},
    {"ColumnTwice", "group", "lot", ":1:121: column lot a second time; accepted: each column once"},
    {"TruncatedRow", "b,L1,270,38.5,10,1000.5,suspended,validation,,,,,\n", "b,L1,270\n",
     ":3:9: 3 fields only; accepted: 13 fields, as in the header"},
    {"LongRow", "24.5\n", "24.5,\n",
     ":4:33: more fields than the header; accepted: 13 fields, as in the header"},
    {"EmptyLine", "c,L2", "\nc,L2", ":4:1: an empty line; accepted: 13 fields, as in the header"},
    {"OpenQuote", "a,L1", "\"a,L1",
     ":2:1: a quoted field that does not end with its quote; accepted: a field with both quotes, "
     "or without"},
    {"EmptyName", "b,L1", ",L1", ":3:1: specimen is empty; accepted: the name of a specimen"},
    {"HiddenCharacter", "red", "re\td",
     ":2:42: group is 're\\td'; accepted: visible characters in UTF-8"},
    {"NotUtf8", "a,L1", "a\xFF,L1",
     ":2:1: specimen is 'a\\xff'; accepted: visible characters in UTF-8"},
    {"Duplicate", "c,L2", "a,L2",
     ":4:1: specimen 'a' a second time, first in line 2; accepted: one row for each specimen"},
    {"ZeroCycles", ",854,", ",0,",
     ":2:17: cycles is '0', out of range; accepted: above 0 up to 1e+18"},
    {"NegativeCycles", ",854,", ",-854,",
     ":2:17: cycles is '-854', out of range; accepted: above 0 up to 1e+18"},
    {"NoCycles", ",854,", ",,", ":2:17: cycles is empty; accepted: " + kNumber},
    {"CyclesNotANumber", ",854,", ",nan,",
     ":2:17: cycles is 'nan', not a finite number; accepted: " + kNumber},
    {"CyclesInfinite", ",854,", ",inf,",
     ":2:17: cycles is 'inf', not a finite number; accepted: " + kNumber},
    {"CyclesWithText", ",854,", ",854 k,",
     ":2:17: cycles is '854 k', not a finite number; accepted: " + kNumber},
    {"UnknownStatus", "suspended", "running",
     ":3:25: status is 'running'; accepted: failed, suspended"},
    {"StatusInCapitals", "failed", "Failed",
     ":2:21: status is 'Failed'; accepted: failed, suspended"},
    {"UnknownRole", "validation", "test", ":3:35: role is 'test'; accepted: fit, validation"},
    {"NegativeDays", "12.5", "-1", ":2:32: days is '-1', out of range; accepted: 0..1000000"},
    {"RatioOfZero", "0.02", "0",
     ":2:37: wire_to_bend_ratio is '0', out of range; accepted: above 0 up to 1000000"},
    {"AngleTooLarge", "315", "1801",
     ":2:6: bend_angle_deg is '1801', out of range; accepted: 0..1800"},
    {"NegativeAmplitude", "38.5,10", "38.5,-10",
     ":3:15: output_tension_amplitude_N is '-10', out of range; accepted: 0..1000000"},
    {"NegativeMean", "25,24.5", "-25,24.5",
     ":4:25: input_tension_mean_N is '-25', out of range; accepted: 0..1000000"},
    {"LoadNotANumber", "49.0", "NaN",
     ":2:10: output_tension_mean_N is 'NaN', not a finite number; accepted: " + kNumber},
    {"HalfALoad", "315,49.0,0", "315,49.0,",
     ":2:15: bend_angle_deg without output_tension_amplitude_N; accepted: " + kLoad},
    {"AngleAlone", "c,L2,,,", "c,L2,90,,",
     ":4:9: bend_angle_deg without output_tension_mean_N; accepted: " + kLoad},
    {"BothLoads", ",,25,24.5", ",,25,24.5\nd,L2,315,49.0,0,854,failed,fit,,,,25,24.5",
     ":5:35: input_tension_mean_N beside bend_angle_deg; accepted: " + kLoad},
};

INSTANTIATE_TEST_SUITE_P(Specimens, BadSpecimens, testing::ValuesIn(kBadTables),
                         [](const auto& bad) { return bad.param.name; });

TEST(Specimens, RefusesATableThatIsNone) {
  EXPECT_EQ(complaint(""), "s.csv: the file is empty; accepted: a CSV file with " + kColumns);
  EXPECT_EQ(complaint("# only a comment\n"),
            "s.csv: the file is empty; accepted: a CSV file with " + kColumns);
  EXPECT_EQ(complaint("specimen,lot,cycles,status\n"),
            "s.csv: no rows; accepted: at least one row after the header");
  EXPECT_EQ(complaint("\nspecimen"),
            "s.csv:1:1: an empty line in place of the header; accepted: " + kColumns);
  EXPECT_EQ(complaint(std::string_view("specimen,lot,cycles,status\na,b\0c,1,failed\n", 42)),
            "s.csv:2:4: a NUL byte; accepted: UTF-8 text");
}

TEST(Specimens, RefusesMissingColumns) {
  EXPECT_EQ(complaint("specimen,lot,cycles\na,b,1\n"),
            "s.csv:1:20: no column status; accepted: " + kColumns);
  EXPECT_EQ(complaint("lot,cycles,status\nb,1,failed\n"),
            "s.csv:1:18: no column specimen; accepted: " + kColumns);
  EXPECT_EQ(complaint("specimen,lot,cycles,status,bend_angle_deg,output_tension_mean_N\n"
                      "a,b,1,failed,,\n"),
            "s.csv:1:64: bend_angle_deg without output_tension_amplitude_N; accepted: " + kLoad);
  EXPECT_EQ(
      complaint("specimen,lot,cycles,status,input_tension_amplitude_N\na,b,1,failed,\n"),
      "s.csv:1:53: input_tension_amplitude_N without input_tension_mean_N; accepted: " + kLoad);
}

}  // namespace
}  // namespace host_sim
