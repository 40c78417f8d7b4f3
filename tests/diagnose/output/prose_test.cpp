#include "host_sim/diagnose/output/prose.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/diagnose/output/hand_made_diagnosis.hpp"

namespace host_sim::diagnose {
namespace {

TEST(MetricDescription, KnowWhatIsBetter) {
  EXPECT_TRUE(improved({"rmse_N", 1.5, 0.5}));
  EXPECT_FALSE(improved({"rmse_N", 0.5, 1.5}));
  EXPECT_TRUE(improved({"log_predictive_density", -1, 1}));
  EXPECT_FALSE(improved({"log_predictive_density", 1, -1}));
  EXPECT_TRUE(improved({"damage_error_percent", -14, 3}));
  // One specimen in ten is to break before B10: 0.02 is as far off as 0.18.
  EXPECT_TRUE(improved({"b10_coverage", 0.3, 0.02}));
  EXPECT_FALSE(improved({"b10_coverage", 0.12, 0.02}));
}

TEST(MetricDescription, AnUnknownNameStandsForItself) {
  EXPECT_EQ(description_of("new_thing").name, "new_thing");
  EXPECT_EQ(description_of("rmse_N").unit, "N");
}

TEST(CostWords, TellTheLifeThatIsPromisedTooMuch) {
  TensionDiagnosis tension = host_sim_test::wear_in_recordings();
  EXPECT_NE(cost_prose(tension).find(
                "0.8 times the damage of the extended one, and so predicts 1.25 times"),
            std::string::npos);
  tension.damage_ratio = 1;
  EXPECT_EQ(cost_prose(tension), "The extension does not change the damage of the recordings.");
  tension.findings.extensions.clear();
  EXPECT_EQ(cost_prose(tension).rfind("Nothing was extended", 0), 0U);
  LifeDiagnosis lives = host_sim_test::lots_in_lives();
  EXPECT_NE(cost_prose(lives).find("predicts 1.25 times the B10"), std::string::npos);
  lives.findings.extensions.clear();
  EXPECT_EQ(cost_prose(lives).rfind("Nothing was extended", 0), 0U);
}

TEST(CandidateWords, TellTwoAtOnce) {
  EXPECT_EQ(candidate_prose("slack"), "slack");
  EXPECT_EQ(candidate_prose("compliance+slack"), "compliance and slack");
}

TEST(TermOf, IsTheWordOfTheField) {
  EXPECT_EQ(term_of("friction_wear"), "wear or run-in of the sheath");
  EXPECT_EQ(term_of("second_mode"), "competing failure mode");
  EXPECT_EQ(term_of("friction_wear+second_mode"),
            "wear or run-in of the sheath and competing failure mode");
  EXPECT_EQ(term_of("none"), "no effect");
  EXPECT_EQ(term_of("never_heard_of"), "never_heard_of");
}

TEST(TermOf, IsTheEffectsOwnWhereTheCatalogueHasNone) {
  const Findings findings = host_sim_test::zero_of_rig().findings;
  EXPECT_EQ(term_of("zero_of_rig", findings), "zero of the rig");
  EXPECT_EQ(term_of("slack+zero_of_rig", findings), term_of("slack") + " and zero of the rig");
  EXPECT_EQ(term_of("slack", findings), term_of("slack"));
  EXPECT_EQ(term_of("none", findings), "no effect");
  EXPECT_EQ(term_of("zero_of_rig"), "zero_of_rig");
}

TEST(Remainder, IsOneSentenceOfWhatIsKnown) {
  Remainder left = host_sim_test::left_over_position();
  EXPECT_EQ(remainder_prose(left),
            "12 % of the squared error, 2.4 N of input tension, most against position (p 0.005)");
  left.share = 0.0034;
  left.covariate = "sheath_temperature";
  left.p = 0.0002;
  EXPECT_EQ(remainder_prose(left),
            "0.34 % of the squared error, 2.4 N of input tension, most against sheath temperature "
            "(p below 0.001)");
  left.input_rmse_N = std::nan("");
  left.p = std::nan("");
  EXPECT_EQ(remainder_prose(left), "0.34 % of the squared error, most against sheath temperature");
  left.share = 1;
  left.covariate.clear();
  EXPECT_EQ(remainder_prose(left), "100 % of the squared error");
}

TEST(CorrectionProse, SaysWhatItIsOverAndThatItIsNoCause) {
  EXPECT_EQ(correction_summary({"travel", 8, 2.4, 1.25}),
            "8 knots over travel by direction, input 2.4 N -> 1.25 N; no cause");
}

TEST(ExperimentsFor, AreThoseOfTheCatalogueFromEitherSide) {
  // EFFECTS.md: wear and temperature are distinguished by cold restarts at several n.
  const std::string experiment = "start from cold at several cycle numbers";
  EXPECT_EQ(experiments_for({"friction_wear", "friction_temperature"}), experiment);
  EXPECT_EQ(experiments_for({"gear_asymmetry", "friction_wear"}), "");
  const std::string three =
      experiments_for({"friction_wear", "friction_temperature", "torque_gain"});
  EXPECT_EQ(three.find(experiment), 0U);
  EXPECT_NE(three.find("; start with a cold winding at several cycle numbers"), std::string::npos);
  EXPECT_EQ(experiments_for({"x", "y"}), "");
}

}  // namespace
}  // namespace host_sim::diagnose
