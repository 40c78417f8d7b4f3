#include "host_sim/diagnose/tension/ranking.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "tests/diagnose/tension/noisy_sessions.hpp"

namespace host_sim::diagnose::testing {
namespace {

/// Five effects of few shapes, so that this is quick.
std::vector<Wanted> catalogue() {
  std::vector<Wanted> wanted;
  for (const char* id : {"friction_preload", "friction_temperature", "friction_wear",
                         "gear_asymmetry", "torque_gain"}) {
    const effects::TensionEffect* effect = component(id).effect;
    wanted.push_back({.effect = effect, .shapes = effect->shapes()});
  }
  return wanted;
}

Ranking ranked(const Disturbances& disturbances) {
  const std::vector<Session> sessions = noisy_sessions(small_design(), disturbances, 8);
  const Evidence evidence = evidence_of(sessions, disturbances.sample_sd);
  GramOptions options = evidence.options;
  options.wanted = catalogue();
  return rank(evidence, gram_of(sessions, options));
}

double heated(const recording::Covariates& c, std::size_t i) {
  return -kMu * 0.01 * (c.sheath_temperature_C[i] - 20) * c.bend_angle_rad[i] * c.direction[i];
}

constexpr double kQuiet_sd = 0.005;
constexpr double kSteady = 0.001;

TEST(Ranking, PrefersNothingWhereNothingIsHidden) {
  EXPECT_EQ(ranked({.sample_sd = kQuiet_sd}).best().id(), "none");
}

TEST(Ranking, PutsTheHiddenEffectFirst) {
  const Ranking ranking = ranked({.sample_sd = kQuiet_sd, .effect = preload(2)});
  EXPECT_TRUE(ranking.best().holds("friction_preload"));
  EXPECT_EQ(ranking.singles.front().id(), "friction_preload");
  EXPECT_GT(ranking.singles.front().log_evidence, ranking.none.log_evidence + 50);
  EXPECT_EQ(ranking.singles.size(), 5U);
}

TEST(Ranking, PutsTwoFirstWhereTwoAreHidden) {
  const Ranking ranking = ranked({.sample_sd = kQuiet_sd,
                                  .session_gain_sd = kSteady,
                                  .session_friction_sd = kSteady,
                                  .effect = [](const recording::Covariates& c, std::size_t i) {
                                    return heated(c, i) + preload(2)(c, i);
                                  }});
  EXPECT_EQ(ranking.best().id(), "friction_preload+friction_temperature");
  EXPECT_TRUE(ranking.best().holds("friction_preload"));
  EXPECT_FALSE(ranking.best().holds("friction_wear"));
}

TEST(Ranking, IsInOrderAndHasEachPairOnceWithItsPartsInOrder) {
  const Ranking ranking = ranked({.sample_sd = kQuiet_sd, .effect = heated});
  const auto worse = [](const Hypothesis& one, const Hypothesis& other) {
    return one.log_evidence > other.log_evidence;
  };
  EXPECT_TRUE(std::ranges::is_sorted(ranking.singles, worse));
  EXPECT_TRUE(std::ranges::is_sorted(ranking.pairs, worse));
  std::set<std::string> ids;
  for (const Hypothesis& pair : ranking.pairs) {
    ASSERT_EQ(pair.parts.size(), 2U);
    EXPECT_LT(pair.parts[0].effect->id(), pair.parts[1].effect->id());
    EXPECT_TRUE(ids.insert(pair.id()).second) << pair.id();
  }
  EXPECT_EQ(ids.size(), 10U);  // all pairs of five: four of them lead, and each pair has one
}

}  // namespace
}  // namespace host_sim::diagnose::testing
