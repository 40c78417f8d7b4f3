#include "tests/blind/scoring/judgement.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/blind/support.hpp"

namespace blind::test {
namespace {

TEST(Judgement, NothingHiddenWantsNoneFirst) {
  const Record right = answered(hiding({}), Verdict::none, {{"none", 0.9}, {"slack", 0.1}});
  EXPECT_TRUE(Judgement(right).right_first());
  EXPECT_FALSE(Judgement(right).named());
  const Record wrong = answered(hiding({}), Verdict::named, {{"slack", 0.97}}, {"slack"});
  EXPECT_FALSE(Judgement(wrong).right_first());
  EXPECT_TRUE(Judgement(wrong).named());
  EXPECT_FALSE(Judgement(wrong).named_right());
}

TEST(Judgement, TheMostProbableCandidateIsTheFirstInAnyOrder) {
  const Record record =
      answered(hiding({"slack"}), Verdict::ambiguous, {{"presliding", 0.3}, {"slack", 0.7}});
  EXPECT_EQ(Judgement(record).first(), "slack");
  EXPECT_EQ(Judgement(record).first_probability(), 0.7);
}

TEST(Judgement, NoCandidateIsNeverRight) {
  const Record record = answered(hiding({"slack"}), Verdict::unknown, {});
  EXPECT_FALSE(Judgement(record).right_first());
  EXPECT_EQ(Judgement(record).first_probability(), 0);
}

TEST(Judgement, AClassHoldsTheTruthOnlyWhereTheAnswerIsAmbiguous) {
  Record record = answered(hiding({"gear_asymmetry"}), Verdict::ambiguous,
                           {{"bend_angle", 0.6}, {"gear_asymmetry", 0.4}});
  EXPECT_FALSE(Judgement(record).right_class());
  record.findings.equivalent_sets = {{"slack", "presliding"}, {"bend_angle", "gear_asymmetry"}};
  EXPECT_TRUE(Judgement(record).right_class());
  EXPECT_FALSE(Judgement(record).right_first());
  record.findings.verdict = Verdict::named;
  EXPECT_FALSE(Judgement(record).right_class());
}

TEST(Judgement, AClassWithoutTheFirstCandidateIsNotRight) {
  Record record = answered(hiding({"gear_asymmetry"}), Verdict::ambiguous,
                           {{"slack", 0.6}, {"gear_asymmetry", 0.4}});
  record.findings.equivalent_sets = {{"bend_angle", "gear_asymmetry"}};
  EXPECT_FALSE(Judgement(record).right_class());
}

TEST(Judgement, TwoAreRightTogetherInOrderOfTheirIds) {
  const Record record = answered(hiding({"slack", "friction_wear"}), Verdict::named,
                                 {{"friction_wear+slack", 0.96}}, {"slack", "friction_wear"});
  EXPECT_TRUE(Judgement(record).right_first());
  EXPECT_TRUE(Judgement(record).named_right());
  EXPECT_TRUE(Judgement(record).named_all());
}

TEST(Judgement, ACandidateOfSeveralMayHaveThemInAnyOrder) {
  const Record record = answered(hiding({"slack", "friction_wear"}), Verdict::named,
                                 {{"slack+friction_wear", 0.96}}, {"slack", "friction_wear"});
  EXPECT_TRUE(Judgement(record).right_first());
  EXPECT_TRUE(Judgement(record).first_is_hidden());
  EXPECT_FALSE(
      Judgement(answered(hiding({"slack"}), Verdict::none, {{"none", 0.9}})).first_is_hidden());
}

TEST(Judgement, OneOfTwoIsARightNameButNotAll) {
  const Record record =
      answered(hiding({"slack", "friction_wear"}), Verdict::named, {{"slack", 0.96}}, {"slack"});
  EXPECT_TRUE(Judgement(record).named_right());
  EXPECT_FALSE(Judgement(record).named_all());
  EXPECT_FALSE(Judgement(record).right_first());
}

TEST(Judgement, ARightAndAWrongNameAreWrong) {
  const Record record = answered(hiding({"slack"}), Verdict::named, {{"presliding+slack", 0.96}},
                                 {"presliding", "slack"});
  EXPECT_FALSE(Judgement(record).named_right());
}

TEST(Judgement, WhatIsFromOutsideWantsUnknownAndNoName) {
  const Record right = answered(hiding_outside("stick_slip"), Verdict::unknown, {{"unknown", 0.8}});
  EXPECT_TRUE(Judgement(right).right_first());
  EXPECT_TRUE(Judgement(right).unknown());
  const Record wrong = answered(hiding_outside("stick_slip"), Verdict::named,
                                {{"stick_slip", 0.99}}, {"stick_slip"});
  EXPECT_FALSE(Judgement(wrong).named_right());
  EXPECT_FALSE(Judgement(wrong).right_first());
}

TEST(Judgement, TheSetCoversTheTruthAlone) {
  Record record = answered(hiding({"slack"}), Verdict::ambiguous, {{"slack", 0.6}});
  record.findings.credible_set = {"presliding"};
  EXPECT_FALSE(Judgement(record).covered());
  record.findings.credible_set = {"presliding", "slack"};
  EXPECT_TRUE(Judgement(record).covered());
  EXPECT_EQ(Judgement(record).set_size(), 2U);
}

TEST(Judgement, EachHiddenEffectMustBeVisible) {
  Record record = answered(hiding({"slack", "friction_wear"}), Verdict::none, {});
  EXPECT_FALSE(Judgement(record).visible_at(0));
  record.visibility = {9, 4.5};
  EXPECT_TRUE(Judgement(record).visible_at(4.5));
  EXPECT_FALSE(Judgement(record).visible_at(5));
}

using host_sim::diagnose::FoundEffect;

// 0.3 (n / 4000)^0.5 is 0.15 at 1000 cycles.
TEST(Parameters, WearIsScaledToTheCataloguesCycles) {
  const HiddenEffect wear{"friction_wear",
                          false,
                          {{"change", {0.3}}, {"reference_cycles", {4000}}, {"exponent", {0.5}}},
                          {{"law", "wear"}}};
  const auto truth = true_parameters(wear);
  ASSERT_EQ(truth.size(), 2U);
  EXPECT_EQ(truth[0].name, "wear_coefficient");
  EXPECT_NEAR(truth[0].value, 0.15, 1e-12);
  EXPECT_EQ(truth[1].value, 0.5);
}

TEST(Parameters, ALagAtTheDriveCountsBackwards) {
  const HiddenEffect lag{
      "filter_lag", false, {{"time_constant_ms", {5}}}, {{"sensor", "motor_current"}}};
  ASSERT_EQ(true_parameters(lag).size(), 1U);
  EXPECT_NEAR(true_parameters(lag)[0].value, -0.005, 1e-12);
  const HiddenEffect late{
      "channel_delay", false, {{"delay_ms", {5}}}, {{"sensor", "output_tension"}}};
  ASSERT_EQ(true_parameters(late).size(), 1U);
  EXPECT_NEAR(true_parameters(late)[0].value, 0.005, 1e-12);
}

// 0.89 and 0.853 about their mean 0.8715: +-2.12 %.
TEST(Parameters, GearAsymmetryIsHalfTheDifference) {
  const HiddenEffect gear{"gear_asymmetry",
                          false,
                          {{"pulling_efficiency", {0.89}}, {"releasing_efficiency", {0.853}}},
                          {}};
  EXPECT_NEAR(true_parameters(gear)[0].value, 0.021228, 1e-6);
}

TEST(Parameters, WhatTheCatalogueHasInAnotherFormIsNotCompared) {
  const HiddenEffect bump{
      "friction_position", false, {{"change", {0.3}}, {"centre_mm", {0}}, {"width_mm", {3}}}, {}};
  EXPECT_TRUE(true_parameters(bump).empty());
}

// 1 / (20 N/mm) is 50e-6 m/N.
TEST(Parameters, OfADriveThatWorksInBothDirections) {
  const auto value = [](const char* id, const char* key, double number, const char* name) {
    for (const TrueParameter& parameter : true_parameters({id, false, {{key, {number}}}, {}})) {
      if (parameter.name == name) {
        return parameter.value;
      }
    }
    return std::nan("");
  };
  EXPECT_NEAR(value("compliance", "stiffness_N_mm", 20, "compliance_m_N"), 50e-6, 1e-12);
  EXPECT_EQ(value("load_cell_zero", "zero_N", -2, "load_cell_zero_N"), -2);
  EXPECT_EQ(value("friction_velocity", "viscous_N_s_m", 30, "viscous_N_s_m"), 30);
  EXPECT_NEAR(value("slack", "dead_zone_mm", 3, "slack_m"), 0.003, 1e-12);
}

TEST(Parameters, ErrorAndCoverageAreByName) {
  FoundEffect found;
  found.parameters = {{"other", "N", 7, 6, 8}, {"preload_N", "N", 2.2, 1.9, 2.1}};
  const auto scores = score_parameters({{"preload_N", 2}, {"not_found", 1}}, found);
  ASSERT_EQ(scores.size(), 1U);
  EXPECT_NEAR(scores[0].relative_error, 0.1, 1e-12);
  EXPECT_TRUE(scores[0].covered);
}

TEST(Parameters, AnIntervalBesideTheTruthDoesNotCover) {
  FoundEffect found;
  found.parameters = {{"droop_1_K", "1/K", 0.001, 0.0009, 0.0011}};
  const auto scores = score_parameters({{"droop_1_K", 0.002}}, found);
  EXPECT_NEAR(scores.at(0).relative_error, 0.5, 1e-12);
  EXPECT_FALSE(scores.at(0).covered);
}

}  // namespace
}  // namespace blind::test
