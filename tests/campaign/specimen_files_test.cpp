#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "host_sim/campaign/campaign_files.hpp"
#include "tests/campaign/support.hpp"

namespace host_sim {

using hal::files::memory_source;

namespace {

using test::replaced;

constexpr std::string_view kGoodSpecimens =
    "specimen,lot,bend_angle_deg,output_tension_mean_N,output_tension_amplitude_N,cycles,status,"
    "role,days,wire_to_bend_ratio,group,input_tension_mean_N,input_tension_amplitude_N\n"
    "a,L1,315,49.0,0,854,failed,fit,12.5,0.02,red,,\n"
    "b,L1,270,38.5,10,1000.5,suspended,validation,,,,,\n"
    "c,L2,,,,500,failed,,0,,,25,24.5\n";

std::vector<SpecimenRow> specimens_in(std::string_view text) {
  return parse_specimens(memory_source(text), "s.csv");
}

std::string specimens_complaint(std::string_view text) {
  return test::complaint_of([&] { specimens_in(text); });
}

TEST(Specimens, ReadsEveryCell) {
  const std::vector<SpecimenRow> rows = specimens_in(kGoodSpecimens);
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
  const auto rows = specimens_in(
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
  EXPECT_EQ(specimens_complaint(replaced(kGoodSpecimens, bad.from, bad.to)),
            "s.csv" + bad.complaint);
}

const std::string kSpecimenColumns =
    "bend_angle_deg, output_tension_mean_N, output_tension_amplitude_N, input_tension_mean_N, "
    "input_tension_amplitude_N, specimen, lot, cycles, status, days, wire_to_bend_ratio, group, "
    "role, cycles_from";
const std::string kLoad =
    "bend_angle_deg with output_tension_mean_N and output_tension_amplitude_N, or "
    "input_tension_mean_N with input_tension_amplitude_N";
const std::string kNumber = "a finite decimal number without spaces";

const std::vector<BadTable> kBadTables{
    {"UnknownColumn", "group", "colour",
     ":1:121: unknown column 'colour'; accepted: " + kSpecimenColumns},
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
     ":3:25: status is 'running'; accepted: failed, suspended, interval, left, trimmed_low, "
     "trimmed_high"},
    {"StatusInCapitals", "failed", "Failed",
     ":2:21: status is 'Failed'; accepted: failed, suspended, interval, left, trimmed_low, "
     "trimmed_high"},
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
  EXPECT_EQ(specimens_complaint(""),
            "s.csv: the file is empty; accepted: a CSV file with " + kSpecimenColumns);
  EXPECT_EQ(specimens_complaint("# only a comment\n"),
            "s.csv: the file is empty; accepted: a CSV file with " + kSpecimenColumns);
  EXPECT_EQ(specimens_complaint("specimen,lot,cycles,status\n"),
            "s.csv: no rows; accepted: at least one row after the header");
  EXPECT_EQ(specimens_complaint("\nspecimen"),
            "s.csv:1:1: an empty line in place of the header; accepted: " + kSpecimenColumns);
  EXPECT_EQ(
      specimens_complaint(std::string_view("specimen,lot,cycles,status\na,b\0c,1,failed\n", 42)),
      "s.csv:2:4: a NUL byte; accepted: UTF-8 text");
}

TEST(Specimens, RefusesMissingColumns) {
  EXPECT_EQ(specimens_complaint("specimen,lot,cycles\na,b,1\n"),
            "s.csv:1:20: no column status; accepted: " + kSpecimenColumns);
  EXPECT_EQ(specimens_complaint("lot,cycles,status\nb,1,failed\n"),
            "s.csv:1:18: no column specimen; accepted: " + kSpecimenColumns);
  EXPECT_EQ(specimens_complaint("specimen,lot,cycles,status,bend_angle_deg,output_tension_mean_N\n"
                                "a,b,1,failed,,\n"),
            "s.csv:1:64: bend_angle_deg without output_tension_amplitude_N; accepted: " + kLoad);
  EXPECT_EQ(
      specimens_complaint("specimen,lot,cycles,status,input_tension_amplitude_N\na,b,1,failed,\n"),
      "s.csv:1:53: input_tension_amplitude_N without input_tension_mean_N; accepted: " + kLoad);
}

using test::CampaignTexts;

const CampaignTexts kGoodBlocks{
    std::string(test::kPaperCampaign),
    "specimen,lot,bend_angle_deg,output_tension_mean_N,output_tension_amplitude_N,cycles,status\n"
    "w,1,315,49,0,800,failed\n"
    "v,1,,,,1000,failed\n"
    "u,1,,,,300.5,suspended\n",
    "specimen,order,bend_angle_deg,output_tension_mean_N,output_tension_amplitude_N,cycles\n"
    "u,2,315,49,0,200.25\n"
    "v,1,270,49,0,600\n"
    "u,1,360,49,0,100.25\n"
    "v,2,405,49,0,400\n"};

TEST(Blocks, AreTheLoadsOfTheirSpecimensInOrder) {
  const Campaign campaign = test::campaign_of(kGoodBlocks);
  ASSERT_EQ(campaign.specimens.size(), 3U);
  const Campaign::Specimen& u = campaign.specimens[0];
  EXPECT_EQ(u.name, "u");
  EXPECT_FALSE(u.constant_load());
  ASSERT_EQ(u.blocks.size(), 2U);
  EXPECT_EQ(u.blocks[0].load.bend_angle_deg, 360.0);
  EXPECT_EQ(u.blocks[0].cycles, 100.25);
  EXPECT_EQ(u.blocks[0].line, 4U);
  EXPECT_EQ(u.blocks[1].load.bend_angle_deg, 315.0);
  EXPECT_EQ(u.blocks[1].cycles, 200.25);
  EXPECT_EQ(u.blocks[1].line, 2U);
  EXPECT_EQ(u.cycles(), 300.5);
  const Campaign::Specimen& v = campaign.specimens[1];
  ASSERT_EQ(v.blocks.size(), 2U);
  EXPECT_EQ(v.blocks[1].load.bend_angle_deg, 405.0);
  const Campaign::Specimen& w = campaign.specimens[2];
  EXPECT_TRUE(w.constant_load());
  EXPECT_EQ(w.blocks.at(0).cycles, 800.0);
  EXPECT_EQ(w.blocks.at(0).line, 2U);
}

TEST(Blocks, OneBlockIsAConstantLoad) {
  CampaignTexts texts = kGoodBlocks;
  texts.blocks = replaced(texts.blocks, "v,1,270,49,0,600\n", "v,1,270,49,0,1000\n");
  texts.blocks = replaced(texts.blocks, "v,2,405,49,0,400\n", "");
  EXPECT_TRUE(test::campaign_of(texts).specimens[1].constant_load());
}

struct BadBlocks {
  std::string name;
  std::string CampaignTexts::*file;
  std::string_view from;
  std::string_view to;
  std::string complaint;
};

void PrintTo(const BadBlocks& bad, std::ostream* out) {
  *out << bad.name;
}

class BadBlockTables : public testing::TestWithParam<BadBlocks> {};

TEST_P(BadBlockTables, AreRefusedWithPlaceFoundAndAccepted) {
  const BadBlocks& bad = GetParam();
  CampaignTexts texts = kGoodBlocks;
  texts.*bad.file = replaced(texts.*bad.file, bad.from, bad.to);
  EXPECT_EQ(test::campaign_complaint(texts), bad.complaint);
}

const std::string kOrder = "each order once: 1, 2, 3 and so on";

const std::vector<BadBlocks> kBadBlocks{
    {"UnknownSpecimen", &CampaignTexts::blocks, "u,1,", "x,1,",
     "b.csv:4:1: a block of 'x', which is no specimen; accepted: specimens of specimens.csv"},
    {"OrderMissing", &CampaignTexts::blocks, "v,2,", "v,3,",
     "b.csv:5:3: order 3 of specimen 'v', but no order 2; accepted: " + kOrder},
    {"OrderStartsAtTwo", &CampaignTexts::blocks, "v,1,270,49,0,600\n", "",
     "b.csv:4:3: order 2 of specimen 'v', but no order 1; accepted: " + kOrder},
    {"OrderTwice", &CampaignTexts::blocks, "v,2,", "v,1,",
     "b.csv:5:3: order 1 of specimen 'v' a second time, first in line 3; accepted: " + kOrder},
    {"OrderZero", &CampaignTexts::blocks, "v,1,", "v,0,",
     "b.csv:3:3: order is '0', out of range; accepted: 1..1000000"},
    {"OrderBroken", &CampaignTexts::blocks, "v,1,", "v,1.5,",
     "b.csv:3:3: order is '1.5'; accepted: a whole number from 1"},
    {"CyclesDoNotSum", &CampaignTexts::blocks, "0,400", "0,399",
     "s.csv:3:8: specimen 'v' has 1000 cycles, but its blocks sum to 999; accepted: the sum of its "
     "blocks in blocks.csv"},
    {"ZeroCycles", &CampaignTexts::blocks, "0,400", "0,0",
     "b.csv:5:14: cycles is '0', out of range; accepted: above 0 up to 1e+18"},
    {"BlockWithoutLoad", &CampaignTexts::blocks, "v,2,405,49,0", "v,2,,,",
     "b.csv:5:1: a block without a load; accepted: " + kLoad},
    {"HalfALoad", &CampaignTexts::blocks, "v,2,405,49,0", "v,2,405,,0",
     "b.csv:5:9: bend_angle_deg without output_tension_mean_N; accepted: " + kLoad},
    {"NoTension", &CampaignTexts::blocks, "v,2,405,49,0", "v,2,405,0,0",
     "b.csv:5:5: effective tension is 0 N; accepted: a load with at least 0.001 N of it"},
    {"PeakAboveTheLimit", &CampaignTexts::blocks, "v,2,405,49,0", "v,2,405,49,60",
     "b.csv:5:5: peak of the input tension is 269.381 N; accepted: less than ultimate_tension_N, "
     "which is 177.4"},
    {"LoadInBothFiles", &CampaignTexts::specimens, "v,1,,,,", "v,1,270,49,0,",
     "s.csv:3:5: a load of specimen 'v', which has blocks from line 3 on; accepted: the load here "
     "or in blocks.csv, not both"},
    {"OtherLoadInBothFiles", &CampaignTexts::specimens, "v,1,,,,", "v,1,450,49,0,",
     "s.csv:3:5: a load of specimen 'v', which has blocks from line 3 on; accepted: the load here "
     "or in blocks.csv, not both"},
    {"NoLoadAtAll", &CampaignTexts::specimens, "w,1,315,49,0,", "w,1,,,,",
     "s.csv:2:1: specimen 'w' has no load; accepted: " + kLoad + ", or rows in blocks.csv"},
    {"UnknownColumn", &CampaignTexts::blocks, "order", "rank",
     "b.csv:1:10: unknown column 'rank'; accepted: bend_angle_deg, output_tension_mean_N, "
     "output_tension_amplitude_N, input_tension_mean_N, input_tension_amplitude_N, specimen, "
     "order, cycles"},
};

INSTANTIATE_TEST_SUITE_P(Blocks, BadBlockTables, testing::ValuesIn(kBadBlocks),
                         [](const auto& bad) { return bad.param.name; });

TEST(Blocks, AcceptASumThatIsRoundedInItsLastDigits) {
  CampaignTexts texts = kGoodBlocks;
  texts.specimens = replaced(texts.specimens, ",300.5,", ",0.3,");
  texts.blocks = replaced(texts.blocks, "200.25", "0.2");
  texts.blocks = replaced(texts.blocks, "100.25", "0.1");
  EXPECT_EQ(test::campaign_complaint(texts), "");
}

constexpr std::string_view kInspected =
    "specimen,lot,cycles,status,cycles_from,input_tension_mean_N,input_tension_amplitude_N\n"
    "a,L,700,interval,600,20,20\n"
    "b,L,500,left,,20,20\n"
    "c,L,900,suspended,,20,20\n";

TEST(Specimens, FoundBrokenLieBetweenTwoInspections) {
  const Campaign campaign =
      test::campaign_of({std::string(test::kPaperCampaign), std::string(kInspected), ""});
  EXPECT_EQ(campaign.specimens[0].status, Campaign::Status::interval);
  EXPECT_EQ(campaign.specimens[0].from_cycles, 600);
  EXPECT_EQ(campaign.specimens[0].cycles(), 700);
  EXPECT_EQ(campaign.specimens[1].status, Campaign::Status::left);
  EXPECT_EQ(campaign.specimens[1].cycles(), 500);
}

TEST(Specimens, AnIntervalThatIsNoneIsRefused) {
  const auto complaint = [](std::string_view from, std::string_view to) {
    return specimens_complaint(test::replaced(kInspected, from, to));
  };
  const std::string accepted =
      "; accepted: cycles_from above 0 and below cycles: at the last inspection before it was "
      "found "
      "broken";
  EXPECT_EQ(complaint("700,interval,600", "700,interval,"),
            "s.csv:2:18: status interval without cycles_from" + accepted);
  EXPECT_EQ(complaint("700,interval,600", "700,interval,700"),
            "s.csv:2:18: cycles_from is 700, and cycles 700" + accepted);
  EXPECT_EQ(complaint("700,interval,600", "700,interval,0"),
            "s.csv:2:18: cycles_from is '0', out of range; accepted: above 0 up to 1e+18");
  EXPECT_EQ(complaint("500,left,", "500,left,100"),
            "s.csv:3:14: cycles_from '100' of a specimen with status 'left'; accepted: an empty "
            "cell, or status interval");
  EXPECT_EQ(specimens_complaint("specimen,lot,cycles,status\na,L,7,interval\n"),
            "s.csv:2:7: status interval without cycles_from" + accepted);
}

constexpr std::string_view kTrimmed =
    "specimen,lot,cycles,status,input_tension_mean_N,input_tension_amplitude_N\n"
    "a,L,,trimmed_low,20,20\n"
    "b,L,700,failed,20,20\n"
    "c,L,900,failed,20,20\n"
    "d,L,,trimmed_high,20,20\n"
    "e,L,100,failed,30,30\n";

TEST(Specimens, TrimmedAreWhereTheLivesOfTheirLevelEnd) {
  const Campaign campaign =
      test::campaign_of({std::string(test::kPaperCampaign), std::string(kTrimmed), ""});
  EXPECT_EQ(campaign.specimens[0].cycles(), 700);
  EXPECT_EQ(campaign.specimens[3].cycles(), 900);
  EXPECT_TRUE(campaign.specimens[0].trimmed());
  EXPECT_EQ(levels_of(campaign).size(), 2U);
}

TEST(Specimens, ATrimmingThatIsNotClearIsRefused) {
  const auto complaint = [](std::string_view from, std::string_view to) {
    return test::campaign_complaint(
        {std::string(test::kPaperCampaign), test::replaced(kTrimmed, from, to), ""});
  };
  EXPECT_EQ(complaint("a,L,,", "a,L,650,"),
            "s.csv:2:5: cycles '650' of a specimen that was trimmed; accepted: an empty cell, or "
            "status failed where the life counts");
  EXPECT_EQ(complaint("700,failed", "800,suspended"),
            "s.csv:2:6: specimen 'a' was trimmed, but 'b' of its level was suspended at 800 "
            "cycles, before the lowest life that was kept, 900; accepted: trimmed_low in levels "
            "without specimens suspended so early");
  EXPECT_EQ(complaint("e,L,100,failed,30,30", "e,L,800,suspended,20,20"),
            "s.csv:5:6: specimen 'd' was trimmed, but 'e' of its level was suspended, and may have "
            "lived longer; accepted: trimmed_high in levels without suspended specimens");
  EXPECT_EQ(complaint("e,L,100,failed,30,30", "e,L,800,left,20,20"),
            "s.csv:2:6: specimen 'a' was trimmed, but 'e' of its level was found broken at an "
            "inspection; accepted: levels whose lives are all known, so that it is clear which "
            "were dropped");
  EXPECT_EQ(complaint("e,L,100,failed", "e,L,,trimmed_low"),
            "s.csv:6:6: specimen 'e' was trimmed, but no other of its level failed; accepted: a "
            "level with specimens whose status is failed");
}

TEST(Specimens, SuspendedAfterTheLowestLifeLeaveItClear) {
  const std::string text =
      test::replaced(test::replaced(kTrimmed, "d,L,,trimmed_high", "d,L,700,suspended"), "", "");
  EXPECT_EQ(test::campaign_complaint({std::string(test::kPaperCampaign), text, ""}), "");
}

TEST(Specimens, InBlocksFailOrAreSuspended) {
  EXPECT_EQ(test::campaign_complaint(
                {std::string(test::kPaperCampaign), "specimen,lot,cycles,status\na,L,300,left\n",
                 "specimen,order,input_tension_mean_N,input_tension_amplitude_N,cycles\n"
                 "a,1,20,20,100\na,2,30,30,200\n"}),
            "s.csv:2:9: specimen 'a', which has blocks, was trimmed or found broken at an "
            "inspection; accepted: failed or suspended for specimens in blocks");
}

}  // namespace

}  // namespace host_sim
