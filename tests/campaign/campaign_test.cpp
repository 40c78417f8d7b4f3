#include "host_sim/campaign/campaign.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/campaign/support.hpp"

namespace host_sim {
namespace {

using testing::StartsWith;

constexpr std::string_view kSpecimens =
    "specimen,lot,cycles,status,input_tension_mean_N,input_tension_amplitude_N\n"
    "b,1,20,failed,25,25\na,1,10,suspended,25,25\n";

std::string complaint_about(const std::filesystem::path& folder) {
  return test::complaint_of([&] { read_campaign(folder); });
}

TEST(CampaignFolder, IsReadWithSpecimensInOrderOfTheirNames) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "campaign.toml", test::kPaperCampaign);
  test::write_text(folder / "specimens.csv", kSpecimens);
  test::write_text(folder / "sessions.csv", "not, a, table, of, ours");
  const Campaign campaign = read_campaign(folder / "");
  EXPECT_EQ(campaign.name, "paper");
  EXPECT_EQ(campaign.folder, folder / "");
  ASSERT_EQ(campaign.specimens.size(), 2U);
  EXPECT_EQ(campaign.specimens[0].name, "a");
  EXPECT_EQ(campaign.specimens[0].line, 3U);
  EXPECT_EQ(campaign.specimens[1].name, "b");
}

TEST(CampaignFolder, IsReadWithItsBlocks) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "campaign.toml", test::kPaperCampaign);
  test::write_text(folder / "specimens.csv", "specimen,lot,cycles,status\na,1,30,failed\n");
  test::write_text(folder / "blocks.csv",
                   "specimen,order,cycles,input_tension_mean_N,input_tension_amplitude_N\n"
                   "a,1,10,30,20\na,2,20,50,20\n");
  EXPECT_EQ(read_campaign(folder / "").specimens.at(0).blocks.size(), 2U);
}

TEST(CampaignFolder, MayHoldRecordingsOnly) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "campaign.toml", test::kPaperCampaign);
  test::write_text(folder / "sessions.csv", "session,specimen,file,start_cycle\n");
  const Campaign campaign = read_campaign(folder / "");
  EXPECT_EQ(campaign.name, "paper");
  EXPECT_TRUE(campaign.nominal.cable);
  EXPECT_TRUE(campaign.specimens.empty());
  test::write_text(folder / "blocks.csv",
                   "specimen,order,cycles,input_tension_mean_N,input_tension_amplitude_N\n"
                   "a,1,10,30,20\n");
  EXPECT_THAT(complaint_about(folder / ""),
              StartsWith((folder / "blocks.csv").string() +
                         ":2:1: a block of 'a', which is no specimen; "));
}

TEST(CampaignFolder, WithSpecimensThatCannotBeReadIsRefusedDespiteRecordings) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "campaign.toml", test::kPaperCampaign);
  test::write_text(folder / "sessions.csv", "session,specimen,file,start_cycle\n");
  std::filesystem::create_symlink(folder / "gone.csv", folder / "specimens.csv");
  EXPECT_THAT(complaint_about(folder / ""),
              StartsWith((folder / "specimens.csv").string() + ": cannot be opened: "));
}

TEST(CampaignFolder, IsRefusedWithTheFileThatIsMissingOrWrong) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(complaint_about(folder / "none"),
            (folder / "none/campaign.toml").string() +
                ": cannot be opened: No such file or directory; accepted: a campaign folder with "
                "campaign.toml (TOML) of at most 1 MiB");
  test::write_text(folder / "campaign.toml", test::kPaperCampaign);
  EXPECT_EQ(complaint_about(folder / ""),
            (folder / "specimens.csv").string() +
                ": cannot be opened: No such file or directory; accepted: a campaign folder with "
                "specimens.csv, sessions.csv or both");
  test::write_text(folder / "specimens.csv", kSpecimens);
  EXPECT_EQ(complaint_about(folder / ""), "");
  test::write_text(folder / "blocks.csv", "");
  EXPECT_THAT(complaint_about(folder / ""),
              StartsWith((folder / "blocks.csv").string() + ": the file is empty; "));
  std::filesystem::remove(folder / "blocks.csv");
  std::filesystem::create_symlink(folder / "gone.csv", folder / "blocks.csv");
  EXPECT_THAT(complaint_about(folder / ""),
              StartsWith((folder / "blocks.csv").string() + ": cannot be opened: "));
}

TEST(ListCampaigns, GivesFoldersWithACampaignByName) {
  const test::TemporaryFolder folder;
  for (const char* const name : {"b", "a", "c10", "c9", "data"}) {
    std::filesystem::create_directory(folder / name);
  }
  for (const char* const name : {"b", "a", "c10", "c9"}) {
    test::write_text(folder / name / "campaign.toml", "");
  }
  test::write_text(folder / "campaign.toml", "");
  const std::vector<std::filesystem::path> expected{folder / "a", folder / "b", folder / "c10",
                                                    folder / "c9"};
  EXPECT_EQ(list_campaigns(folder / ""), expected);
  EXPECT_TRUE(is_campaign(folder / "a"));
  EXPECT_FALSE(is_campaign(folder / "data"));
  EXPECT_TRUE(list_campaigns(folder / "data").empty());
}

TEST(ListCampaigns, RefusesWhatIsNoFolder) {
  const test::TemporaryFolder folder;
  const std::string none = (folder / "none").string();
  EXPECT_EQ(
      test::complaint_of([&] { list_campaigns(none); }),
      none + ": cannot be listed: No such file or directory; accepted: a folder of campaigns");
}

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
