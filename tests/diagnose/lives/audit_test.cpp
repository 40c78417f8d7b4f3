#include "host_sim/diagnose/lives/audit.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>

#include "tests/diagnose/lives/scenario.hpp"
#include "tests/diagnose/lives/texts.hpp"

namespace host_sim::diagnose::lives {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

LifeAudit audit_of(const Campaign& campaign) {
  const LifeSample sample = sample_of(campaign, Campaign::Role::fit);
  return audit_lives(sample, campaign.specimens, fit_nominal(sample));
}

const LifeEffectAudit& of(const LifeAudit& audit, std::string_view id) {
  for (const LifeEffectAudit& effect : audit.effects) {
    if (effect.effect->id() == id) {
      return effect;
    }
  }
  throw std::out_of_range(std::string(id));
}

/// Eight lives at each tension, all of one lot or of two that are crossed with them.
std::string lives_at(const std::vector<double>& tensions_N, int lots) {
  std::string text = test::kHeader;
  int number = 0;
  for (const double tension_N : tensions_N) {
    for (int i = 0; i < 8; ++i) {
      const double cycles = 1.53e5 * std::pow(tension_N, -1.38) * (0.8 + 0.05 * i);
      text += fmt::format("s{},{},0,{},{:.0f},failed,fit\n", 100 + number++, i % lots, tension_N,
                          cycles);
    }
  }
  return text;
}

TEST(LifeProjection, LeavesWhatIsNoPowerLaw) {
  const Eigen::Vector3d x(-1, 0, 1);
  const LifeProjection projection(x, Eigen::Vector3d(4, 4, 4));
  EXPECT_NEAR(projection.left(Eigen::Vector3d(1, 3, 5)).norm(), 0, 1e-12);
  // x^2 less its mean 2/3 is (1, -2, 1)/3; times a root of weight 2.
  const Eigen::MatrixXd left = projection.left(Eigen::Vector3d(1, 0, 1));
  EXPECT_NEAR(left(0), 2.0 / 3, 1e-12);
  EXPECT_NEAR(left(1), -4.0 / 3, 1e-12);
}

TEST(LifeProjection, ImitationIsTheCosineOfColumns) {
  EXPECT_NEAR(imitated(Eigen::Vector2d(1, 1), Eigen::Vector2d(1, 0)), std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(imitated(Eigen::Vector2d(1, 1), Eigen::Matrix2d::Identity()), 1, 1e-12);
}

TEST(LifeAudit, ACrossedPlanShowsAll) {
  const LifeAudit audit = audit_of(host_sim::test::simulated({96, "none", 20004}));
  for (const LifeEffectAudit& effect : audit.effects) {
    EXPECT_TRUE(effect.visible()) << effect.effect->id() << ": " << effect.why;
  }
}

TEST(LifeAudit, TellsWhatIsMissing) {
  const LifeAudit audit = audit_of(test::campaign_of(lives_at({30, 40, 55, 75}, 1)));
  EXPECT_THAT(of(audit, "ageing").why, HasSubstr("days"));
  EXPECT_THAT(of(audit, "bending_fatigue").why, HasSubstr("wire_to_bend_ratio"));
  EXPECT_THAT(of(audit, "load_sequence").why, HasSubstr("blocks"));
  EXPECT_THAT(of(audit, "lot_frailty").why, HasSubstr("second lot"));
  EXPECT_TRUE(of(audit, "second_mode").visible());
}

// Without a mean tension Gerber, Walker and Goodman are one law.
TEST(LifeAudit, NoMeanTensionShowsNoMeanStress) {
  const LifeAudit audit = audit_of(test::campaign_of(lives_at({30, 40, 55, 75}, 2)));
  EXPECT_FALSE(of(audit, "mean_stress").visible());
  EXPECT_THAT(of(audit, "mean_stress").why, HasSubstr("its signature vanishes"));
  EXPECT_THAT(of(audit, "mean_stress").why, HasSubstr("vary the mean"));
  EXPECT_THAT(audit.visible(), Not(Contains("mean_stress")));
}

TEST(LifeAudit, TwoLevelsShowNoCurvature) {
  const LifeAudit audit = audit_of(test::campaign_of(lives_at({30, 60}, 2)));
  EXPECT_THAT(of(audit, "endurance_limit").why, HasSubstr("three levels"));
}

// A and gamma take what a mode does to the mean at two levels or at one, and not its scatter.
TEST(LifeAudit, ASecondModeShowsInTheScatterOfOneLevel) {
  for (const std::vector<double>& tensions_N :
       {std::vector<double>{30, 60}, std::vector<double>{50}}) {
    const LifeAudit audit = audit_of(test::campaign_of(lives_at(tensions_N, 2)));
    EXPECT_TRUE(of(audit, "second_mode").visible());
    EXPECT_THAT(audit.equivalent, IsEmpty());
  }
}

// Levels 284 to 333 apart by 17 % in all: what a limit does to their mean a power law does as well.
TEST(LifeAudit, ALimitShowsInTheScatterOfLevelsThatAreNear) {
  const LifeAudit audit =
      audit_of(test::campaign_of(lives_at({28.4, 29.4, 30.4, 31.4, 32.4, 33.3}, 2)));
  EXPECT_TRUE(of(audit, "endurance_limit").visible());
}

TEST(LifeAudit, CurvatureOfThreeLevelsIsALimitOrAMode) {
  const LifeAudit audit = audit_of(test::campaign_of(lives_at({30, 45, 70}, 2)));
  ASSERT_EQ(audit.equivalent.size(), 1U);
  EXPECT_THAT(audit.equivalent.front(), Contains("endurance_limit"));
  EXPECT_THAT(audit.equivalent.front(), Contains("second_mode"));
  EXPECT_THAT(audit.equivalent.front(), Not(Contains("lot_frailty")));
}

TEST(LifeAudit, WhatIsTakenOutOfTheCatalogueIsTheLikeOfNothing) {
  const Campaign campaign = test::campaign_of(lives_at({30, 45, 70}, 2));
  const LifeSample sample = sample_of(campaign, Campaign::Role::fit);
  const std::vector<std::string> without{"second_mode", "ageing"};
  const LifeAudit audit = audit_lives(sample, campaign.specimens, fit_nominal(sample), without);
  EXPECT_THAT(audit.equivalent, IsEmpty());
  EXPECT_THAT(audit.visible(), Contains("endurance_limit"));
  for (const LifeEffectAudit& effect : audit.effects) {
    EXPECT_THAT(without, Not(Contains(effect.effect->id())));
  }
}

}  // namespace
}  // namespace host_sim::diagnose::lives
