#include "host_sim/diagnose/force/force_candidates.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "tests/diagnose/force/joint.hpp"

namespace host_sim::diagnose {
namespace {

/// Of 16 sessions a parameter counts ln(16)/2 = ln 4 against an effect, which is there with odds of
/// 1 to 19 before: evidence z^2/2 of 19 * 4 * odds makes these odds of it.
Judged of_odds(effects::ForceTerm term, double odds) {
  Judged one{.term = term, .gain = {}, .without = {}, .held_without = {}};
  one.gain.z = std::sqrt(2 * std::log(19 * 4 * odds));
  one.gain.taken_N2 = 1;
  return one;
}

const ForceData& sixteen_sessions() {
  static const ForceData data(measured({}, 3, 16));
  return data;
}

std::map<std::string, double> found(const std::vector<Judged>& judged, const std::string& rest,
                                    bool remainder_stands,
                                    const std::vector<LeftOut>& left_out = {}) {
  std::map<std::string, double> all;
  double sum = 0;
  double before = 1;
  for (const Candidate& one :
       candidates_of(sixteen_sessions(), judged, left_out, rest, remainder_stands)) {
    EXPECT_LE(one.probability, before) << "most probable first";
    before = one.probability;
    sum += one.probability;
    all.emplace(one.id, one.probability);
  }
  EXPECT_NEAR(sum, 1, 1e-12);
  return all;
}

TEST(ForceCandidates, WithoutEffectsTheRestIsAll) {
  EXPECT_EQ(found({}, "none", false), (std::map<std::string, double>{{"none", 1}}));
}

/// Of what is left out 35 % is there: 0.65 that it is not of one that is certain, times 0.825 of
/// one that is even; the rest by their probabilities.
TEST(ForceCandidates, WhatIsLeftOutMayBeThere) {
  const LeftOut certain{effects::ForceTerm::slack, 1, 0.04};
  const LeftOut even{effects::ForceTerm::delay, 0.5, 0};
  auto all = found({}, "none", false, {certain, even});
  EXPECT_NEAR(all.at("none"), 0.53625, 1e-12);
  EXPECT_NEAR(all.at("slack"), 0.46375 * 2 / 3, 1e-12);
  EXPECT_NEAR(all.at("channel_delay"), 0.46375 / 3, 1e-12);
  all = found({of_odds(effects::ForceTerm::preload, 1e12)}, "unknown", false, {certain});
  EXPECT_NEAR(all.at("friction_preload"), 0.65, 1e-9);
  EXPECT_NEAR(all.at("friction_preload+slack"), 0.35, 1e-9);
  const LeftOut third{effects::ForceTerm::compliance, 1, 0};
  const LeftOut fourth{effects::ForceTerm::lag, 1, 0};
  all = found({}, "none", false, {certain, third, fourth});
  EXPECT_NEAR(all.at("none"), 0.5, 1e-12) << "nothing is as likely as the model as it is";
  EXPECT_NEAR(all.at("compliance"), 0.5 / 3, 1e-12);
  EXPECT_EQ(found({}, "unknown", true, {certain}).size(), 1U) << "that more is wrong is known";
}

/// 0.96 that it is not the one, times 0.99 that it is not the other.
TEST(ForceCandidates, WhatIsNotSeenMayBeThere) {
  const auto all =
      found({}, "none", false,
            {{effects::ForceTerm::slack, 0, 0.04}, {effects::ForceTerm::delay, 0.01, 0.01}});
  EXPECT_NEAR(all.at("none"), 0.9504, 1e-12);
  EXPECT_NEAR(all.at("slack"), 0.0496 * 4 / 5, 1e-12);
  EXPECT_NEAR(all.at("channel_delay"), 0.0496 / 5, 1e-12);
}

/// Of odds of 1 to 19: all are left where a campaign shows nothing of an effect, and a half of them
/// where one standard deviation of its size would be sqrt(3) standard errors.
TEST(ForceCandidates, WhatACampaignCannotShowIsAsLikelyAsBefore) {
  EXPECT_NEAR(unseen_probability(0), 0.05, 1e-12);
  EXPECT_NEAR(unseen_probability(std::sqrt(3)), 1.0 / 39, 1e-12);
  EXPECT_LT(unseen_probability(1e3), 1e-4);
}

/// Odds of 99 are 0.99 of both, each by itself.
TEST(ForceCandidates, EffectsOfAModelAreTogether) {
  const auto all =
      found({of_odds(effects::ForceTerm::slack, 99), of_odds(effects::ForceTerm::preload, 99)},
            "unknown", false);
  EXPECT_NEAR(all.at("friction_preload+slack"), 0.99 * 0.99, 1e-9);
  EXPECT_NEAR(all.at("unknown"), 1 - 0.99 * 0.99, 1e-9);
  EXPECT_EQ(all.size(), 2);
}

/// Odds of 4 are 0.8, with and without it beside one that is certain.
TEST(ForceCandidates, AnEffectThatMayNotBeNamedIsThereOrNot) {
  const auto alone = found({of_odds(effects::ForceTerm::load, 4)}, "none", false);
  EXPECT_NEAR(alone.at("friction_load"), 0.8, 1e-9);
  EXPECT_NEAR(alone.at("none"), 0.2, 1e-9);

  const auto beside =
      found({of_odds(effects::ForceTerm::preload, 1e9), of_odds(effects::ForceTerm::load, 4)},
            "none", false);
  EXPECT_NEAR(beside.at("friction_load+friction_preload"), 0.8, 1e-6);
  EXPECT_NEAR(beside.at("friction_preload"), 0.2, 1e-6);
}

/// Another law of the same effect adds to it, another effect in its place has the odds of that.
TEST(ForceCandidates, WhatCouldBeInItsPlaceHasItsOdds) {
  Judged one = of_odds(effects::ForceTerm::presliding, 1e9);
  one.others = {{effects::ForceTerm::compliance, std::log(2.0)},
                {effects::ForceTerm::elastic_presliding, 0}};
  const auto all = found({one}, "unknown", false);
  EXPECT_NEAR(all.at("presliding"), 0.8, 1e-6);
  EXPECT_NEAR(all.at("compliance"), 0.2, 1e-6);
}

TEST(ForceCandidates, WhatCouldBeInThePlaceOfTwoIsOne) {
  Judged preload = of_odds(effects::ForceTerm::preload, 1e9);
  preload.others = {{effects::ForceTerm::velocity, 0}};
  Judged lag = of_odds(effects::ForceTerm::lag, 1e9);
  lag.others = {{effects::ForceTerm::velocity, 0}};
  const auto all = found({preload, lag}, "unknown", false);
  EXPECT_NEAR(all.at("friction_velocity"), 0.25, 1e-6);
  EXPECT_NEAR(all.at("filter_lag+friction_velocity"), 0.25, 1e-6);
}

TEST(ForceCandidates, OfTwoThatAreEvenTheOneThatTheModelHasIsFirst) {
  Judged one = of_odds(effects::ForceTerm::delay, 1e9);
  one.others = {{effects::ForceTerm::lag, 0}};
  const std::vector<LeftOut> left_out{{effects::ForceTerm::lag, 0, 0.04},
                                      {effects::ForceTerm::slack, 0, 0.04}};
  const auto candidates =
      candidates_of(sixteen_sessions(), std::vector{one}, left_out, "none", false);
  EXPECT_EQ(candidates[0].id, "channel_delay");
  EXPECT_EQ(candidates[1].id, "filter_lag");
  EXPECT_EQ(candidates[0].probability, candidates[1].probability);
}

TEST(ForceCandidates, WhatIsLeftHasACauseOfItsOwnByThirtyPercent) {
  const auto all = found({of_odds(effects::ForceTerm::preload, 1e9)}, "unknown", true);
  EXPECT_NEAR(all.at("friction_preload"), 0.7, 1e-6);
  EXPECT_NEAR(all.at("friction_preload+unknown"), 0.3, 1e-6);
}

/// What the catalogue does not have is as likely: a half of it is unknown.
TEST(ForceCandidates, WhatIsImitatedHasItsShare) {
  Judged one = of_odds(effects::ForceTerm::load, 1e9);
  one.share = 0.5;
  const auto all = found({one}, "unknown", false);
  EXPECT_NEAR(all.at("friction_load"), 0.5, 1e-6);
  EXPECT_NEAR(all.at("unknown"), 0.5, 1e-6);
}

}  // namespace
}  // namespace host_sim::diagnose
