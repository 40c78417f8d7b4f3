#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "host_sim/campaign/blocks_file.hpp"
#include "tests/campaign/support.hpp"

namespace host_sim {
namespace {

using test::CampaignTexts;
using test::replaced;

const CampaignTexts kGood{
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
  const Campaign campaign = test::campaign_of(kGood);
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
  CampaignTexts texts = kGood;
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
  CampaignTexts texts = kGood;
  texts.*bad.file = replaced(texts.*bad.file, bad.from, bad.to);
  EXPECT_EQ(test::campaign_complaint(texts), bad.complaint);
}

const std::string kLoad =
    "bend_angle_deg with output_tension_mean_N and output_tension_amplitude_N, or "
    "input_tension_mean_N with input_tension_amplitude_N";
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
  CampaignTexts texts = kGood;
  texts.specimens = replaced(texts.specimens, ",300.5,", ",0.3,");
  texts.blocks = replaced(texts.blocks, "200.25", "0.2");
  texts.blocks = replaced(texts.blocks, "100.25", "0.1");
  EXPECT_EQ(test::campaign_complaint(texts), "");
}

}  // namespace
}  // namespace host_sim
