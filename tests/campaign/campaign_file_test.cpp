#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "host_sim/campaign/campaign_files.hpp"
#include "tests/campaign/support.hpp"

namespace host_sim {
namespace {

using test::replaced;

constexpr std::string_view kGoodCampaign = R"(schema = 1
[campaign]
name = "wires"
[model.cable]
diameter_mm = 0.457
ultimate_tension_N = 177.4
[model.sheath]
friction_coefficient = 0.128
bend_angle_deg = 270.0
[model.counting]
sample_rate_Hz = 200
hysteresis_N = 0.2
[[use]]
name = "glove"
input_tension_mean_N = 25.0
input_tension_amplitude_N = 25.0
[[use]]
name = "mix"
parts = [
  { share = 0.25, effective_tension_N = 40.0 },
  { share = 0.75, effective_tension_N = 50.0 },
]
)";

std::string campaign_file_complaint(std::string_view text) {
  return test::complaint_of([&] { parse_campaign_file(text, "c.toml"); });
}

TEST(CampaignFile, ReadsNameModelAndUses) {
  const CampaignFile file = parse_campaign_file(kGoodCampaign, "c.toml");
  EXPECT_EQ(file.name, "wires");
  ASSERT_TRUE(file.nominal.cable.has_value());
  EXPECT_EQ(file.nominal.cable->diameter_mm, 0.457);
  EXPECT_EQ(file.nominal.cable->ultimate_tension_N, 177.4);
  ASSERT_TRUE(file.nominal.sheath.has_value());
  EXPECT_EQ(file.nominal.sheath->friction_coefficient, 0.128);
  EXPECT_EQ(file.nominal.sheath->bend_angle_deg, 270.0);
  ASSERT_TRUE(file.nominal.counting.has_value());
  EXPECT_EQ(file.nominal.counting->sample_rate_Hz, 200.0);
  EXPECT_EQ(file.nominal.counting->hysteresis_N, 0.2);
  EXPECT_FALSE(file.nominal.drive.has_value());
  EXPECT_FALSE(file.nominal.life.has_value());
  ASSERT_EQ(file.uses.size(), 2U);
  EXPECT_EQ(file.uses[0].name, "glove");
  ASSERT_EQ(file.uses[0].parts.size(), 1U);
  EXPECT_EQ(file.uses[0].parts[0].share, 1.0);
  EXPECT_EQ(file.uses[0].parts[0].load.input_tension_mean_N, 25.0);
  EXPECT_EQ(file.uses[1].name, "mix");
  ASSERT_EQ(file.uses[1].parts.size(), 2U);
  EXPECT_EQ(file.uses[1].parts[0].share, 0.25);
  EXPECT_EQ(file.uses[1].parts[0].load.effective_tension_N, 40.0);
  EXPECT_EQ(file.uses[1].parts[1].share, 0.75);
  EXPECT_EQ(file.uses[1].parts[1].load.effective_tension_N, 50.0);
}

TEST(CampaignFile, ReadsTheWholeModel) {
  const CampaignFile file = parse_campaign_file(std::string(kGoodCampaign) + R"([model.drive]
torque_constant_Nm_per_A = 0.0325
gear_ratio = 9.0
gear_efficiency = 0.88
spool_radius_mm = 12.5
current_offset_A = 0.0
[model.life]
mean_stress = "gerber"
ipl_scale = 1.53e5
ipl_exponent = 1.38
weibull_shape = 5.94
)",
                                                "c.toml");
  ASSERT_TRUE(file.nominal.drive.has_value());
  EXPECT_EQ(file.nominal.drive->gear_ratio, 9.0);
  ASSERT_TRUE(file.nominal.life.has_value());
  EXPECT_EQ(file.nominal.life->ipl_exponent, 1.38);
}

TEST(CampaignFile, NeedsOnlyAName) {
  const CampaignFile file = parse_campaign_file("campaign.name = 'x'", "c.toml");
  EXPECT_EQ(file.name, "x");
  EXPECT_FALSE(file.nominal.cable.has_value());
  EXPECT_TRUE(file.uses.empty());
}

TEST(CampaignFile, SaysWhetherTheDriveWorksInBothDirections) {
  const auto two_sided = [](const std::string& line) {
    return parse_campaign_file("[campaign]\nname = 'x'\n" + line, "c.toml").two_sided;
  };
  EXPECT_FALSE(two_sided(""));
  EXPECT_FALSE(two_sided("two_sided = false\n"));
  EXPECT_TRUE(two_sided("two_sided = true\n"));
}

// A tension that is given stands for an amplitude around zero: Gerber's (11) has it unchanged.
TEST(CampaignFile, TakesAnEffectiveTensionAsAmplitudeAroundZero) {
  const CampaignFile file = parse_campaign_file(
      "[campaign]\nname = 'x'\n[[use]]\nname = 'a'\neffective_tension_N = 44.0\n", "c.toml");
  const Campaign::Load& load = file.uses.at(0).parts.at(0).load;
  EXPECT_FALSE(load.bend_angle_deg.has_value());
  EXPECT_EQ(load.input_tension_mean_N, 0.0);
  EXPECT_EQ(load.input_tension_amplitude_N, 44.0);
  EXPECT_EQ(load.effective_tension_N, 44.0);
}

struct BadFile {
  std::string name;
  std::string_view from;
  std::string_view to;
  std::string complaint;
};

void PrintTo(const BadFile& bad, std::ostream* out) {
  *out << bad.name;
}

class BadCampaignFiles : public testing::TestWithParam<BadFile> {};

TEST_P(BadCampaignFiles, AreRefusedWithPlaceFoundAndAccepted) {
  const BadFile& bad = GetParam();
  EXPECT_EQ(campaign_file_complaint(replaced(kGoodCampaign, bad.from, bad.to)),
            "c.toml" + bad.complaint);
}

const std::string kLoadOfUse =
    "bend_angle_deg with output_tension_mean_N and output_tension_amplitude_N, or "
    "input_tension_mean_N with input_tension_amplitude_N, or effective_tension_N";
const std::string kLoadOfUsePart =
    "bend_angle_deg with output_tension_mean_N and output_tension_amplitude_N, or "
    "input_tension_mean_N with input_tension_amplitude_N";
const std::string kMix =
    "parts = [{ share, load }, ...], at least two whose shares of the cycles sum to 1";

const std::vector<BadFile> kBadFiles{
    {"OtherSchema", "schema = 1", "schema = 2", ":1:1: schema is 2; accepted: schema = 1"},
    {"UnknownTable", "[campaign]", "[cable]\nx = 1\n[campaign]",
     ":2:2: unknown table 'cable'; accepted: campaign, model, use, schema"},
    {"NoCampaign", "[campaign]\nname = \"wires\"\n", "",
     ": no table [campaign]; accepted: a table [campaign]"},
    {"NoName", "name = \"wires\"\n", "",
     ":2:2: no key name in [campaign]; accepted: name as a text of visible characters"},
    {"EmptyName", "\"wires\"", "\"\"",
     ":3:1: name is ''; accepted: name as a text of visible characters"},
    {"HiddenCharacters", "\"wires\"", "\"a\\u202eb\"",
     ":3:1: name is 'a\\xe2\\x80\\xaeb'; accepted: name as a text of visible characters"},
    {"NameOfWrongType", "\"wires\"", "7",
     ":3:1: name is 7; accepted: name as a text of visible characters"},
    {"UnknownKey", "name = \"wires\"", "name = \"wires\"\nlab = 1",
     ":4:1: unknown key 'lab' in [campaign]; accepted: name, two_sided"},
    {"TwoSidedOfWrongType", "name = \"wires\"", "name = \"wires\"\ntwo_sided = 1",
     ":4:1: two_sided is 1; accepted: two_sided as true or false"},
    {"UnknownTableOfModel", "[model.cable]", "[model.rope]\n[model.cable]",
     ":4:8: unknown table 'rope' in [model]; accepted: cable, sheath, drive, counting, life, "
     "watch"},
    {"OtherUnitOfModel", "ultimate_tension_N = 177.4", "ultimate_tension_kN = 0.1774",
     ":6:1: unknown unit 'kN' of key 'ultimate_tension_kN'; accepted: ultimate_tension_N "
     "1..1000000"},
    {"MissingKeyOfModel", "ultimate_tension_N = 177.4\n", "",
     ":4:8: no key ultimate_tension_N in [model.cable]; accepted: ultimate_tension_N 1..1000000"},
    {"ModelOutOfRange", "friction_coefficient = 0.128", "friction_coefficient = 1.5",
     ":8:1: friction_coefficient is 1.5; accepted: friction_coefficient 0..1"},
    {"Hysteresis", "hysteresis_N = 0.2", "hysteresis_N = 200",
     ":12:1: hysteresis_N is 200; "
     "accepted: less than ultimate_tension_N, which is 177.4"},
    {"UseIsATable", "[[use]]\nname = \"glove\"", "[use]\nname = \"glove\"",
     ":17:1: Error while parsing table header: cannot redefine existing table 'use' as "
     "array-of-tables; accepted: TOML 1.0"},
    {"UnknownKeyOfUse", "name = \"glove\"", "name = \"glove\"\nhand = 1",
     ":15:1: unknown key 'hand' in [use]; accepted: bend_angle_deg, output_tension_mean_N, "
     "output_tension_amplitude_N, input_tension_mean_N, input_tension_amplitude_N, "
     "effective_tension_N, name, parts"},
    {"OtherUnitOfUse", "input_tension_mean_N = 25.0", "input_tension_mean_kN = 25.0",
     ":15:1: unknown unit 'kN' of key 'input_tension_mean_kN'; accepted: input_tension_mean_N "
     "0..1000000"},
    {"UseWithoutName", "name = \"glove\"\n", "",
     ":13:1: no key name in [use]; accepted: name as a text of visible characters"},
    {"UseASecondTime", "name = \"mix\"", "name = \"glove\"",
     ":18:1: use 'glove' a second time; accepted: a name for each use"},
    {"UseWithoutLoad", "input_tension_mean_N = 25.0\ninput_tension_amplitude_N = 25.0\n", "",
     ":13:1: a use without a load; accepted: " + kLoadOfUse + ", or parts of a mix"},
    {"UseWithLoadAndParts", "name = \"mix\"", "name = \"mix\"\neffective_tension_N = 3",
     ":17:1: a load beside parts; accepted: " + kLoadOfUse + ", or parts of a mix"},
    {"HalfALoad", "input_tension_mean_N = 25.0\n", "",
     ":13:1: input_tension_amplitude_N without input_tension_mean_N; accepted: " + kLoadOfUse},
    {"TwoLoads", "input_tension_mean_N = 25.0", "input_tension_mean_N = 25.0\nbend_angle_deg = 90",
     ":13:1: bend_angle_deg without output_tension_mean_N; accepted: " + kLoadOfUse},
    {"NegativeAmplitude", "input_tension_amplitude_N = 25.0", "input_tension_amplitude_N = -1",
     ":16:1: input_tension_amplitude_N is -1; accepted: input_tension_amplitude_N 0..1000000"},
    {"NotANumber", "input_tension_amplitude_N = 25.0", "input_tension_amplitude_N = nan",
     ":16:1: input_tension_amplitude_N is nan; accepted: input_tension_amplitude_N 0..1000000"},
    {"NoAmplitude", "input_tension_amplitude_N = 25.0", "input_tension_amplitude_N = 0",
     ":15:1: effective tension is 0 N; accepted: a load with at least 0.001 N of it"},
    {"PeakAtTheLimit", "input_tension_amplitude_N = 25.0", "input_tension_amplitude_N = 152.4",
     ":15:1: peak of the input tension is 177.4 N; accepted: less than ultimate_tension_N, which "
     "is 177.4"},
    {"EffectiveTensionAtTheLimit", "effective_tension_N = 40.0", "effective_tension_N = 177.4",
     ":20:19: effective tension is 177.4 N; accepted: less than ultimate_tension_N, which is "
     "177.4"},
    {"SharesDoNotSum", "share = 0.25", "share = 0.250000002",
     ":19:1: the shares sum to 1.000000002; accepted: " + kMix},
    {"ShareOfNothing", "share = 0.25", "share = 0.0",
     ":20:5: share is 0.0; accepted: share above 0 up to 1"},
    {"PartWithoutShare", "share = 0.25, ", "",
     ":20:3: no key share in [use.parts]; accepted: share above 0 up to 1"},
    {"PartWithoutLoad", ", effective_tension_N = 40.0", "",
     ":20:3: a part without a load; accepted: " + kLoadOfUse},
    {"PartWithAName", "share = 0.25", "name = 'x', share = 0.25",
     ":20:5: unknown key 'name' in [use.parts]; accepted: bend_angle_deg, output_tension_mean_N, "
     "output_tension_amplitude_N, input_tension_mean_N, input_tension_amplitude_N, "
     "effective_tension_N, share"},
    {"OnePart", "  { share = 0.25, effective_tension_N = 40.0 },\n", "",
     ":19:1: 1 parts; accepted: " + kMix},
    {"PartIsANumber", "{ share = 0.25, effective_tension_N = 40.0 }", "3",
     ":20:3: parts holds 3; accepted: " + kMix},
};

INSTANTIATE_TEST_SUITE_P(CampaignFile, BadCampaignFiles, testing::ValuesIn(kBadFiles),
                         [](const auto& bad) { return bad.param.name; });

TEST(CampaignFile, TakesSharesThatSumToOneWithinRounding) {
  EXPECT_EQ(
      campaign_file_complaint(replaced(kGoodCampaign, "share = 0.25", "share = 0.2500000005")), "");
}

TEST(CampaignFile, RefusesUsesThatAreNoTables) {
  EXPECT_EQ(campaign_file_complaint("use = 3\n[campaign]\nname = 'x'\n"),
            "c.toml:1:1: use is 3; accepted: tables [[use]]");
  EXPECT_EQ(campaign_file_complaint("use = [3]\n[campaign]\nname = 'x'\n"),
            "c.toml:1:8: use holds 3; accepted: tables [[use]]");
  EXPECT_EQ(campaign_file_complaint("model = 3\n[campaign]\nname = 'x'\n"),
            "c.toml:1:1: model is 3; accepted: a table [model]");
}

TEST(CampaignFile, SaysWhatTheModelLacks) {
  const std::string cable =
      "[campaign]\nname = 'x'\n[model.cable]\ndiameter_mm = 1\n"
      "ultimate_tension_N = 100\n";
  const std::string use =
      "[[use]]\nname = 'u'\nbend_angle_deg = 90\noutput_tension_mean_N = 10\n"
      "output_tension_amplitude_N = 0\n";
  EXPECT_EQ(campaign_file_complaint("[campaign]\nname = 'x'\n" + use),
            "c.toml: no table [model.cable]; accepted: [model.cable] with ultimate_tension_N, "
            "which the load at c.toml:5 needs");
  EXPECT_EQ(campaign_file_complaint(cable + use),
            "c.toml:3:2: no table [model.sheath]; accepted: [model.sheath] with "
            "friction_coefficient, which the load at c.toml:8 needs");
}

}  // namespace
}  // namespace host_sim
