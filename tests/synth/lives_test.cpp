#include "host_sim/synth/campaign/lives.hpp"

#include <map>
#include <set>

#include "host_sim/campaign/assemble.hpp"
#include "host_sim/synth/campaign/campaign_text.hpp"
#include "tests/synth/support.hpp"

namespace host_sim::synth::test {
namespace {

const std::string kLives = R"(
[lives]
lots = 3
[[lives.level]]
bend_angle_deg = 0
output_tension_mean_N = 30
output_tension_amplitude_N = 30
specimens = 2000
[[lives.level]]
bend_angle_deg = 90
output_tension_mean_N = 40
output_tension_amplitude_N = 20
specimens = 6
role = "validation"
suspend_at_cycles = 10
)";

Campaign campaign_of(const SynthPlan& plan, const LifeTexts& texts) {
  std::vector<BlockRow> blocks;
  if (!texts.blocks.empty()) {
    blocks = parse_blocks(memory_source(texts.blocks), "blocks.csv");
  }
  return assemble(parse_campaign_file(campaign_text(plan), "campaign.toml"),
                  parse_specimens(memory_source(texts.specimens), "specimens.csv"), blocks);
}

TEST(SynthLives, LivesAreThoseOfTheWeibullLaw) {
  const auto specimens = run_lives(plan_of(kLives), 1);
  // T_eff = 30 / (1 - (30 / 177.4)^2) = 30.883; 1.53e5 / T^1.38 = 1346; 63.2 % fail before.
  constexpr double kScale = 1346;
  std::size_t before = 0;
  double sum = 0;
  for (std::size_t i = 0; i < 2000; ++i) {
    ASSERT_TRUE(specimens[i].result.failed);
    const double cycles = specimens[i].result.cycles.front();
    before += cycles < kScale ? 1 : 0;
    sum += std::log(cycles / kScale);
  }
  EXPECT_NEAR(static_cast<double>(before) / 2000, 0.632, 5 * std::sqrt(0.632 * 0.368 / 2000));
  // Mean of ln: -0.5772 / beta, sd 1.283 / beta.
  EXPECT_NEAR(sum / 2000, -0.5772 / 5.94, 5 * 1.283 / 5.94 / std::sqrt(2000));
}

TEST(SynthLives, TheFilesAreACampaign) {
  const SynthPlan plan = plan_of(kLives);
  const Campaign campaign = campaign_of(plan, life_texts(plan, 1));
  ASSERT_EQ(campaign.specimens.size(), 2006U);
  EXPECT_EQ(campaign.name, "small");
  const auto& last = campaign.specimens.back();
  EXPECT_EQ(last.status, Campaign::Status::suspended);
  EXPECT_EQ(last.role, Campaign::Role::validation);
  EXPECT_EQ(last.cycles(), 10);
  EXPECT_EQ(last.blocks.front().load.bend_angle_deg, 90);
  EXPECT_EQ(last.lot, "lot3");
  EXPECT_FALSE(last.days);
}

TEST(SynthLives, ProgramsGoFromLevelToLevel) {
  const SynthPlan plan =
      plan_of(kLives + "[[lives.program]]\nlevels = [1, 2]\ncycles = [100]\nspecimens = 4\n");
  const Campaign campaign = campaign_of(plan, life_texts(plan, 1));
  const auto& last = campaign.specimens.back();
  ASSERT_EQ(last.blocks.size(), 2U);
  EXPECT_EQ(last.blocks[0].cycles, 100);
  EXPECT_EQ(last.blocks[1].cycles, 10);
  EXPECT_EQ(last.blocks[1].load.bend_angle_deg, 90);
}

TEST(SynthLives, LotsAreCrossedWithLevelsOrNested) {
  const auto pairs = [](const std::string& text) {
    std::set<std::pair<std::size_t, std::size_t>> found;
    for (const LifeSpecimen& specimen : run_lives(plan_of(text), 1)) {
      found.emplace(specimen.levels.front(), specimen.place.lot);
    }
    return found.size();
  };
  EXPECT_EQ(pairs(kLives), 6U);
  std::string nested = kLives;
  nested.replace(nested.find("lots = 3"), 8, "lots = 3\nlots_by = \"level\"");
  EXPECT_EQ(pairs(nested), 2U);
}

TEST(SynthLives, RigsAreCrossedWithLots) {
  std::string text = kLives;
  text.replace(text.find("lots = 3"), 8, "lots = 3\nrigs = 2");
  std::map<std::pair<std::size_t, std::size_t>, int> count;
  for (const LifeSpecimen& specimen : run_lives(plan_of(text), 1)) {
    ++count[{specimen.place.lot, specimen.place.rig}];
  }
  EXPECT_EQ(count.size(), 6U);
  const LifeTexts texts = life_texts(plan_of(text), 1);
  EXPECT_NE(texts.specimens.find(",rig2\n"), std::string::npos);
}

TEST(SynthLives, RecordsWhatIsAskedFor) {
  std::string text = kLives;
  text.replace(text.find("lots = 3"), 8, "storage_days = [5, 9]\nrecord_days = true");
  text.replace(text.find("bend_angle_deg = 0"), 18,
               "bend_angle_deg = 0\nwire_to_bend_ratio = 0.04");
  const SynthPlan plan = plan_of(text);
  const Campaign campaign = campaign_of(plan, life_texts(plan, 1));
  EXPECT_GE(*campaign.specimens[0].days, 5);
  EXPECT_LT(*campaign.specimens[0].days, 5.1);
  EXPECT_GE(*campaign.specimens[1].days, 9);
  EXPECT_EQ(campaign.specimens[0].wire_to_bend_ratio, 0.04);
  EXPECT_FALSE(campaign.specimens.back().wire_to_bend_ratio);
}

TEST(SynthLives, DependOnTheSeedAlone) {
  const SynthPlan plan = plan_of(kLives);
  EXPECT_EQ(life_texts(plan, 4).specimens, life_texts(plan, 4).specimens);
  EXPECT_NE(life_texts(plan, 4).specimens, life_texts(plan, 5).specimens);
}

}  // namespace
}  // namespace host_sim::synth::test
