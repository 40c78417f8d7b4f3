#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>

#include "host_sim/diagnose/diagnosis.hpp"
#include "host_sim/effects/life_effect.hpp"
#include "tests/diagnose/lives/texts.hpp"

namespace host_sim::diagnose {
namespace {

using lives::test::campaign_of;
using lives::test::kHeader;
using ::testing::HasSubstr;

std::string row(int number, double tension_N, double cycles, const char* status) {
  return fmt::format("s{},1,0,{},{:.0f},{},fit\n", 100 + number, tension_N, cycles, status);
}

LifeDiagnosis expect_nothing_asked(const Campaign& campaign, const std::string& why) {
  const LifeDiagnosis diagnosis = diagnose_lives(campaign, {});
  EXPECT_EQ(diagnosis.findings.verdict, Verdict::none);
  EXPECT_THAT(diagnosis.findings.prose, HasSubstr("cannot be diagnosed"));
  EXPECT_EQ(diagnosis.findings.doubts.size(), 1U);
  if (!diagnosis.findings.doubts.empty()) {
    EXPECT_THAT(diagnosis.findings.doubts[0].words, HasSubstr(why));
    EXPECT_TRUE(diagnosis.findings.doubts[0].spoils);
  }
  EXPECT_EQ(diagnosis.findings.invisible.size(), effects::life_effects().size());
  EXPECT_TRUE(diagnosis.findings.effects.empty());
  return diagnosis;
}

void expect_nothing_asked(const std::string& specimens, const std::string& why) {
  EXPECT_EQ(expect_nothing_asked(campaign_of(specimens), why).ipl_scale, 1.53e5);
}

TEST(DiagnoseLivesBadInput, OneLevelWithoutAModelOfLife) {
  std::string text = kHeader;
  for (int i = 0; i < 20; ++i) {
    text += row(i, 50, 700 + 10 * i, "failed");
  }
  expect_nothing_asked(campaign_of(text, 177.4, ""), "give the campaign a [model.life]");
}

TEST(DiagnoseLivesBadInput, AllSuspended) {
  std::string text = kHeader;
  for (int i = 0; i < 20; ++i) {
    text += row(i, 30 + 10 * (i % 3), 500, "suspended");
  }
  expect_nothing_asked(text, "0 of 20 specimens failed");
}

TEST(DiagnoseLivesBadInput, FailuresAtOneLevelAlone) {
  std::string text = kHeader;
  for (int i = 0; i < 20; ++i) {
    text += i % 2 == 0 ? row(i, 50, 700 + 10 * i, "failed") : row(i, 30, 500, "suspended");
  }
  expect_nothing_asked(text, "gamma");
}

TEST(DiagnoseLivesBadInput, LivesWithoutScatter) {
  std::string text = kHeader;
  for (int i = 0; i < 20; ++i) {
    text += row(i, i % 2 == 0 ? 30 : 60, i % 2 == 0 ? 1400 : 540, "failed");
  }
  expect_nothing_asked(text, "without any scatter");
}

/// A wire of 0.457 mm over a sheave of 14 mm is 0.033 of it, and not 30.
TEST(DiagnoseLivesBadInput, ARatioTheWrongWayRoundIsInDoubt) {
  std::string text = kHeader;
  for (int i = 0; i < 20; ++i) {
    text += row(i, 30 + 10 * (i % 3), 1400 - 200 * (i % 3) + 7 * i, "failed");
  }
  Campaign campaign = campaign_of(text);
  for (Campaign::Specimen& specimen : campaign.specimens) {
    specimen.wire_to_bend_ratio = 0.033;
  }
  EXPECT_TRUE(diagnose_lives(campaign, {}).findings.doubts.empty());
  for (Campaign::Specimen& specimen : campaign.specimens) {
    specimen.wire_to_bend_ratio = 30;
  }
  const std::vector<Doubt> doubts = diagnose_lives(campaign, {}).findings.doubts;
  ASSERT_EQ(doubts.size(), 1U);
  EXPECT_EQ(doubts[0].column, "wire_to_bend_ratio");
  EXPECT_THAT(doubts[0].words, HasSubstr("D/d in place of d/D"));
}

TEST(DiagnoseLivesBadInput, AFewFailuresNameNothing) {
  std::string text = kHeader;
  for (int i = 0; i < 8; ++i) {
    text += row(i, 30.0 + 10 * (i % 4),
                1.5e5 * std::pow(30 + 10 * (i % 4), -1.38) * (0.8 + 0.05 * i), "failed");
  }
  const LifeDiagnosis diagnosis = diagnose_lives(campaign_of(text), {});
  EXPECT_NE(diagnosis.findings.verdict, Verdict::named);
}

}  // namespace
}  // namespace host_sim::diagnose
