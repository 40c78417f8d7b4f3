#include "host_sim/diagnose/tension/decision.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "tests/diagnose/tension/noisy_sessions.hpp"

namespace host_sim::diagnose::testing {
namespace {

using ::testing::ElementsAre;

Hypothesis single(std::string_view id, double log_evidence) {
  return {{component(id)}, log_evidence};
}

Ranking two_singles(double wear, double slack) {
  return {
      .none = {}, .singles = {single("friction_wear", wear), single("slack", slack)}, .pairs = {}};
}

ResidualTest one_probe(double statistic, double freedom, double p) {
  return {.probes = {{Probe::Of::speed, statistic, freedom, p}}};
}

TEST(Weigh, GivesTheEvidenceTimesThePrior) {
  const Ranking ranking = two_singles(10, 4);
  const Weighed weighed = weigh(ranking, ranking.best(), {});
  // Tempered by 1 + 0.0005 10; 0.65 none, 0.125 each, and 0.05 as odds of structure beside the
  // best.
  const double none = 0.65;
  const double wear = 0.125 * std::exp(10 / 1.005);
  const double slack = 0.125 * std::exp(4 / 1.005);
  const double sum = none + wear + slack + 0.05 * wear;
  EXPECT_NEAR(weighed.of("none"), none / sum, 1e-12);
  EXPECT_NEAR(weighed.of("friction_wear"), wear / sum, 1e-12);
  EXPECT_NEAR(weighed.of("slack"), slack / sum, 1e-12);
  EXPECT_NEAR(weighed.of("unknown"), 0.05 * wear / sum, 1e-12);
  EXPECT_EQ(weighed.of("compliance"), 0);
}

TEST(Weigh, ListsTheMostProbableFirstAndAllOfThemMakeOne) {
  const Ranking ranking = two_singles(3, 12);
  const Weighed weighed = weigh(ranking, ranking.singles[1], {});
  EXPECT_EQ(weighed.candidates.front().id, "slack");
  double sum = 0;
  double last = 1;
  for (const Candidate& candidate : weighed.candidates) {
    EXPECT_LE(candidate.probability, last);
    last = candidate.probability;
    sum += candidate.probability;
  }
  EXPECT_NEAR(sum, 1, 1e-12);
}

TEST(Weigh, StructureThatIsLeftSpeaksForTheUnknownWithinWhatItsPAllows) {
  const Ranking ranking = two_singles(10, 4);
  const auto odds = [&](const ResidualTest& rest) {
    const Weighed weighed = weigh(ranking, ranking.best(), rest);
    return weighed.of("unknown") / weighed.of("friction_wear");
  };
  // Less than its freedom says nothing.
  EXPECT_NEAR(odds(one_probe(9, 10, 0.6)), 0.05, 1e-12);
  // -1 - ln(-0.1 ln 0.1) = 0.46848
  EXPECT_NEAR(odds(one_probe(40, 10, 0.1)), 0.05 * std::exp(0.46848), 1e-5);
  // (40 - 10 - 10 ln 4)/2 = 8.06853 where p cannot be less.
  EXPECT_NEAR(odds(one_probe(40, 10, 0.001)), 0.05 * std::exp(8.06853), 1e-2);
  // One in a hundred of what the effects explain may be left: 40 - 0.01 2000 = 20 on 10.
  ResidualTest large = one_probe(40, 10, 0.001);
  large.explained = 2000;
  EXPECT_NEAR(odds(large), 0.05 * std::exp(1.53426), 1e-5);
  // Of two probes one is this high twice as easily.
  ResidualTest both = one_probe(40, 10, 0.001);
  both.probes.push_back({Probe::Of::cycle, 5, 10, 0.9});
  EXPECT_NEAR(odds(both), 0.025 * std::exp(8.06853), 1e-2);
}

TEST(Dispersion, IsTheLargestExcessThatIsSignificant) {
  EXPECT_EQ(dispersion_of({}), 1);
  EXPECT_EQ(dispersion_of(one_probe(40, 10, 0.002)), 4);
  EXPECT_EQ(dispersion_of(one_probe(40, 10, 0.02)), 1);
  EXPECT_EQ(dispersion_of(one_probe(5, 10, 0.002)), 1);
  EXPECT_EQ(dispersion_of(one_probe(5, 0, 0.002)), 1);
}

TEST(Weigh, EvidencesOfAWrongModelCountLess) {
  const Ranking ranking = two_singles(40, 28);
  const ResidualTest rest = one_probe(40, 10, 0.002);
  const Weighed weighed = weigh(ranking, ranking.best(), rest);
  EXPECT_NEAR(std::log(weighed.of("friction_wear") / weighed.of("slack")), 12.0 / 4, 1e-9);
}

TEST(Weigh, PairsShareAPriorOfTheirOwn) {
  Ranking ranking = two_singles(10, 4);
  ranking.pairs.push_back({{component("friction_wear"), component("slack")}, 10});
  const Weighed weighed = weigh(ranking, ranking.best(), {});
  // One pair of two effects: 0.05, less what tempering took off its second effect.
  const double tempering = std::exp(-3 * (1 - 1 / 1.005));
  EXPECT_NEAR(weighed.of("friction_wear+slack") / weighed.of("friction_wear"),
              0.05 * tempering / 0.125, 1e-9);
  EXPECT_NEAR(weighed.marginal("slack"), weighed.of("slack") + weighed.of("friction_wear+slack"),
              1e-12);
}

TEST(Weigh, ASecondEffectThatShiftsSessionsIsNotWhatAStrokeLeaves) {
  Ranking ranking{
      .none = {}, .singles = {single("slack", 10'000), single("friction_wear", 50)}, .pairs = {}};
  ranking.pairs.push_back({{component("friction_wear"), component("slack")}, 10'024});
  ranking.pairs.push_back({{component("filter_lag"), component("slack")}, 10'012});
  const Weighed weighed = weigh(ranking, ranking.singles.front(), {});
  // Two singles: one pair of them, with 0.05 to 0.125. All is tempered by 1 + 0.0005 10,000 = 6,
  // wear beside slack by 1 + 0.00001 10,000 = 1.1.
  EXPECT_NEAR(std::log(weighed.of("friction_wear+slack") / weighed.of("slack")),
              std::log(0.05 / 0.125) + 24 / 1.1 - 3 * (1 - 1 / 1.1), 1e-9);
  EXPECT_NEAR(std::log(weighed.of("filter_lag+slack") / weighed.of("slack")),
              std::log(0.05 / 0.125) + 12.0 / 6 - 3 * (1 - 1.0 / 6), 1e-9);
  // Where wear is the first, slack beside it is within the stroke.
  ranking.singles = {single("friction_wear", 10'000), single("slack", 50)};
  const Weighed other = weigh(ranking, ranking.singles.front(), {});
  EXPECT_NEAR(std::log(other.of("friction_wear+slack") / other.of("friction_wear")),
              std::log(0.05 / 0.125) + 24.0 / 6 - 3 * (1 - 1.0 / 6), 1e-9);
}

TEST(Weigh, APairThatImitatesTheBestIsTemperedAsTheBestIs) {
  Ranking ranking{.none = {},
                  .singles = {single("friction_preload", 10'000), single("friction_load", 8'000)},
                  .pairs = {}};
  ranking.pairs.push_back({{component("bend_angle"), component("friction_load")}, 9'940});
  const Weighed weighed = weigh(ranking, ranking.singles.front(), {});
  EXPECT_NEAR(std::log(weighed.of("friction_preload") / weighed.of("bend_angle+friction_load")),
              std::log(0.125 / 0.05) + 60.0 / 6 + 3 * (1 - 1.0 / 6), 1e-9);
}

TEST(Weigh, WhatIsLeftTempersEverySecondEffect) {
  Ranking ranking{
      .none = {}, .singles = {single("slack", 40), single("friction_wear", 4)}, .pairs = {}};
  ranking.pairs.push_back({{component("friction_wear"), component("slack")}, 60});
  const Weighed weighed = weigh(ranking, ranking.pairs.front(), one_probe(40, 10, 0.002));
  EXPECT_NEAR(std::log(weighed.of("friction_wear+slack") / weighed.of("slack")),
              std::log(0.05 / 0.125) + 20.0 / 4 - 3 * (1 - 1.0 / 4), 1e-9);
}

TEST(Weighed, MarginalsAreOfWholeIds) {
  const Weighed weighed{{{"friction_wear+slack", 0.5}, {"slack", 0.3}, {"none", 0.2}}};
  EXPECT_DOUBLE_EQ(weighed.marginal("slack"), 0.8);
  EXPECT_DOUBLE_EQ(weighed.marginal("friction_wear"), 0.5);
  EXPECT_EQ(weighed.marginal("friction"), 0);
}

TEST(Weighed, TheCredibleSetIsTheSmallestThatHoldsTheShare) {
  const Weighed weighed{{{"a", 0.6}, {"b", 0.3}, {"c", 0.06}, {"d", 0.04}}};
  EXPECT_THAT(credible_set_of(weighed.candidates, 0.95), ElementsAre("a", "b", "c"));
  EXPECT_THAT(credible_set_of(weighed.candidates, 0.5), ElementsAre("a"));
}

TEST(Decide, NamesFromNinetyFivePercentOn) {
  EXPECT_EQ(decide({{{"slack", 0.95}, {"none", 0.05}}}), Verdict::named);
  EXPECT_EQ(decide({{{"slack", 0.949}, {"none", 0.051}}}), Verdict::ambiguous);
  EXPECT_EQ(decide({{{"none", 0.5}, {"slack", 0.5}}}), Verdict::none);
  EXPECT_EQ(decide({{{"unknown", 0.5}, {"slack", 0.5}}}), Verdict::unknown);
}

}  // namespace
}  // namespace host_sim::diagnose::testing
