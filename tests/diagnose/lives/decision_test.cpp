#include "host_sim/diagnose/lives/decision.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace host_sim::diagnose::lives {
namespace {

using ::testing::ElementsAre;

Hypothesis hypothesis(std::vector<std::string> effects, double probability, bool outside = false) {
  Hypothesis made;
  made.effects = std::move(effects);
  made.outside = outside;
  made.probability = probability;
  made.forms.emplace_back();
  return made;
}

TEST(LifeDecision, NamesAnEffectThatTakesPartInNearlyAll) {
  const std::vector<Hypothesis> hypotheses{hypothesis({"ageing"}, 0.90),
                                           hypothesis({"ageing", "lot_frailty"}, 0.06),
                                           hypothesis({}, 0.04)};
  const Decision decision = decide(hypotheses, 0.001);
  EXPECT_EQ(decision.verdict, Verdict::named);
  EXPECT_THAT(decision.effects, ElementsAre("ageing"));
  EXPECT_NEAR(decision.probabilities.front(), 0.96, 1e-12);
  EXPECT_EQ(decision.best, &hypotheses[0]);
  EXPECT_THAT(decision.credible_set, ElementsAre("ageing", "ageing+lot_frailty"));
  EXPECT_EQ(decide(hypotheses, 0.4).verdict, Verdict::ambiguous);
}

TEST(LifeDecision, NamesTwoWhereBothAreNeeded) {
  const Decision decision = decide({hypothesis({"ageing", "lot_frailty"}, 0.97),
                                    hypothesis({"ageing"}, 0.02), hypothesis({}, 0.01)},
                                   0.001);
  EXPECT_THAT(decision.effects, ElementsAre("ageing", "lot_frailty"));
}

TEST(LifeDecision, OfWhatCannotBeToldIsAmbiguous) {
  const Decision decision = decide({hypothesis({"endurance_limit"}, 0.5),
                                    hypothesis({"second_mode"}, 0.46), hypothesis({}, 0.04)},
                                   0.001);
  EXPECT_EQ(decision.verdict, Verdict::ambiguous);
  EXPECT_THAT(decision.credible_set, ElementsAre("endurance_limit", "second_mode"));
}

TEST(LifeDecision, OfAllThatIsOutsideIsUnknown) {
  const Decision decision = decide({hypothesis({"group"}, 0.5, true),
                                    hypothesis({"load"}, 0.3, true), hypothesis({"ageing"}, 0.2)},
                                   0.001);
  EXPECT_EQ(decision.verdict, Verdict::unknown);
  EXPECT_EQ(decision.candidates.front().id, "unknown");
  EXPECT_NEAR(decision.candidates.front().probability, 0.8, 1e-12);
  EXPECT_TRUE(decision.effects.empty());
}

TEST(LifeDecision, OfNothingNeedsResidualsThatLookLikeIt) {
  const std::vector<Hypothesis> hypotheses{hypothesis({}, 0.6), hypothesis({"ageing"}, 0.4)};
  EXPECT_EQ(decide(hypotheses, 0.3).verdict, Verdict::none);
  EXPECT_EQ(decide(hypotheses, 0.01).verdict, Verdict::ambiguous);
  EXPECT_EQ(decide({hypothesis({}, 0.9), hypothesis({"ageing"}, 0.1)}, 0.01).verdict,
            Verdict::none);
}

TEST(LifeCalibration, ShareOfEachIsThatOfPriorAndEvidence) {
  std::vector<Hypothesis> hypotheses{hypothesis({}, 0), hypothesis({"ageing"}, 0),
                                     hypothesis({"lot_frailty"}, 0),
                                     hypothesis({"group"}, 0, true)};
  hypotheses[1].log_evidence = std::log(10);
  calibrate(hypotheses, {.power = 1, .ln_single = std::log(2), .ln_pair = 0, .ln_outside = 0});
  // 1, 10, 1 and 1 of 13.
  EXPECT_EQ(hypotheses[0].id(), "ageing");
  EXPECT_NEAR(hypotheses[0].probability, 10.0 / 13, 1e-12);
  EXPECT_NEAR(hypotheses[3].probability, 1.0 / 13, 1e-12);
}

TEST(LifeCalibration, WeightsOfAPairAreThoseOfBoth) {
  std::vector<Hypothesis> hypotheses{hypothesis({}, 0), hypothesis({"ageing"}, 0),
                                     hypothesis({"lot_frailty"}, 0),
                                     hypothesis({"ageing", "lot_frailty"}, 0)};
  hypotheses[3].log_evidence = std::log(5);
  calibrate(hypotheses, {.power = 2,
                         .ln_single = std::log(2),
                         .ln_pair = std::log(4),
                         .ln_outside = 0,
                         .ln_weights = {{"ageing", std::log(3)}}});
  // None 1; of two singles 2 x 3 / 2 = 3 and 2 / 2 = 1; the pair 25 x 4 x 3 / (2 x 2) = 75: of 80.
  EXPECT_EQ(hypotheses[0].id(), "ageing+lot_frailty");
  EXPECT_NEAR(hypotheses[0].probability, 75.0 / 80, 1e-12);
  EXPECT_EQ(hypotheses[1].id(), "ageing");
  EXPECT_NEAR(hypotheses[1].probability, 3.0 / 80, 1e-12);
}

}  // namespace
}  // namespace host_sim::diagnose::lives
