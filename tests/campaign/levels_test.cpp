#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/campaign/support.hpp"

namespace host_sim {
namespace {

Campaign campaign_with(const std::string& rows, const std::string& blocks = "") {
  return test::campaign_of(
      {std::string(test::kPaperCampaign),
       "specimen,lot,cycles,status,role,bend_angle_deg,output_tension_mean_N,"
       "output_tension_amplitude_N,input_tension_mean_N,input_tension_amplitude_N\n" +
           rows,
       blocks});
}

std::vector<std::string> names(const Level& level) {
  std::vector<std::string> names;
  for (const Campaign::Specimen* const specimen : level.specimens) {
    names.push_back(specimen->name);
  }
  return names;
}

using Names = std::vector<std::string>;

TEST(Levels, AreLoadsInOrderOfEffectiveTension) {
  const Campaign campaign = campaign_with(
      "a,1,1,failed,fit,360,49,0,,\n"
      "b,1,2,failed,fit,315,49,0,,\n"
      "c,1,3,suspended,fit,360,49,0,,\n"
      "d,1,4,failed,fit,,,,25,25\n");
  const std::vector<Level> levels = levels_of(campaign);
  ASSERT_EQ(levels.size(), 3U);
  EXPECT_EQ(names(levels[0]), Names{"d"});
  EXPECT_EQ(names(levels[1]), Names{"b"});
  EXPECT_EQ(names(levels[2]), (Names{"a", "c"}));
  EXPECT_FALSE(levels[0].load.bend_angle_deg.has_value());
  EXPECT_EQ(levels[2].load.bend_angle_deg, 360.0);
  EXPECT_LT(levels[0].load.effective_tension_N, levels[1].load.effective_tension_N);
  EXPECT_LT(levels[1].load.effective_tension_N, levels[2].load.effective_tension_N);
}

TEST(Levels, KeepRolesApart) {
  const Campaign campaign = campaign_with(
      "a,1,1,failed,validation,360,49,0,,\n"
      "b,1,2,failed,fit,360,49,0,,\n"
      "c,1,3,failed,validation,360,49,0,,\n");
  const std::vector<Level> levels = levels_of(campaign);
  ASSERT_EQ(levels.size(), 2U);
  EXPECT_EQ(levels[0].role, Campaign::Role::fit);
  EXPECT_EQ(names(levels[0]), Names{"b"});
  EXPECT_EQ(levels[1].role, Campaign::Role::validation);
  EXPECT_EQ(names(levels[1]), (Names{"a", "c"}));
}

// At 0 deg output and input tension are the same, but one level knows its angle.
TEST(Levels, KeepLoadsWithAndWithoutAngleApart) {
  const Campaign campaign = campaign_with(
      "a,1,1,failed,fit,0,50,20,,\n"
      "b,1,2,failed,fit,,,,50,20\n");
  EXPECT_EQ(levels_of(campaign).size(), 2U);
}

TEST(Levels, LeaveOutSpecimensInBlocks) {
  const Campaign campaign = campaign_with(
      "a,1,30,failed,fit,,,,,\n"
      "b,1,2,failed,fit,360,49,0,,\n",
      "specimen,order,cycles,input_tension_mean_N,input_tension_amplitude_N\n"
      "a,1,10,30,20\na,2,20,50,20\n");
  const std::vector<Level> levels = levels_of(campaign);
  ASSERT_EQ(levels.size(), 1U);
  EXPECT_EQ(names(levels[0]), Names{"b"});
}

}  // namespace
}  // namespace host_sim
