#include "host_sim/diagnose/diagnosis.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/diagnose/output/hand_made_diagnosis.hpp"

namespace host_sim::diagnose {
namespace {

TEST(Gain, IsOneOfTheErrorElseOfTheDensity) {
  EXPECT_TRUE(improves({"session", {{"rmse_N", 1.5, 1.4}, {"log_predictive_density", 3, 2}}}));
  EXPECT_FALSE(improves({"session", {{"rmse_N", 1.5, 1.5}}}));
  EXPECT_FALSE(improves({"session", {{"log_predictive_density", 2, 3}, {"rmse_N", 1.5, 1.6}}}));
  EXPECT_FALSE(improves({"session", {{"rmse_N", 1.5, std::nan("")}}}));
  EXPECT_FALSE(improves({"session", {{"log_predictive_density", 2, 3}, {"rmse_N", 1.5, 1.52}}}));
  EXPECT_TRUE(
      improves({"session", {{"log_predictive_density", 2, 3}, {"input_rmse_N", 1.5, 1.52}}}));
  EXPECT_FALSE(
      improves({"session", {{"log_predictive_density", 2, 3}, {"input_rmse_N", 1.5, 1.54}}}));
  const std::vector<Metric> scattered{{"log_predictive_density", 2, 3}, {"input_rmse_N", 1.5, 1.6}};
  EXPECT_TRUE(improves({"session", scattered, true}));
  EXPECT_FALSE(improves({"session", {{"log_predictive_density", 3, 2}, scattered[1]}, true}));
  EXPECT_FALSE(improves({"session", {scattered[0], {"input_rmse_N", 1.5, 1.7}}, true}));
  EXPECT_TRUE(
      improves({"session", {{"input_rmse_N", 1.5, 1.4}, {"damage_error_percent", 10, 14.9}}}));
  EXPECT_FALSE(
      improves({"session", {{"input_rmse_N", 1.5, 1.4}, {"damage_error_percent", 10, 15.1}}}));
  EXPECT_TRUE(improves({"session", {{"rmse_N", 1.5, 1.6}, {"input_rmse_N", 1.5, 1.4}}}));
  EXPECT_FALSE(
      improves({"session", {{"log_predictive_density", 3, 2}, {"input_rmse_N", 1.5, 1.52}}}));
  EXPECT_TRUE(
      improves({"level", {{"log_predictive_density", -2, -1}, {"b10_coverage", 0.1, 0.3}}}));
  EXPECT_FALSE(improves({"level", {{"log_predictive_density", -1, -2}}}));
  EXPECT_FALSE(improves({}));
}

TEST(Gain, WhatDoesNotGainIsNotNamedAndNotWritten) {
  Findings findings = host_sim_test::wear_in_recordings().findings;
  EXPECT_FALSE(withdraw_unless_improved(findings));
  EXPECT_EQ(findings.verdict, Verdict::named);
  EXPECT_EQ(findings.extensions.size(), 1U);
  EXPECT_EQ(no_gain_prose(findings), "");

  findings.gain.metrics = {{"rmse_N", 0.5, 1.5}};
  EXPECT_TRUE(withdraw_unless_improved(findings));
  EXPECT_EQ(findings.verdict, Verdict::ambiguous);
  EXPECT_TRUE(findings.extensions.empty());
  EXPECT_NE(no_gain_prose(findings).find("nothing was extended"), std::string::npos);

  Findings none;
  EXPECT_FALSE(withdraw_unless_improved(none));
  EXPECT_EQ(no_gain_prose(none), "");
}

TEST(Parts, RecordingsComeFirst) {
  const Diagnosis diagnosis = host_sim_test::both_parts();
  const auto parts = findings_by_data(diagnosis);
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].name, "recordings");
  EXPECT_EQ(parts[0].findings, &diagnosis.tension->findings);
  EXPECT_EQ(parts[1].findings, &diagnosis.lives->findings);
  EXPECT_TRUE(findings_by_data({}).empty());
}

TEST(Parts, MergedHoldAllOfBoth) {
  const Findings all = merged(host_sim_test::both_parts());
  EXPECT_EQ(all.verdict, Verdict::named);
  ASSERT_EQ(all.effects.size(), 2U);
  EXPECT_EQ(all.effects[1].id, "lot_frailty");
  EXPECT_EQ(all.candidates.size(), 4U);
  EXPECT_EQ(all.credible_set, (std::vector<std::string>{"friction_wear", "lot_frailty"}));
  EXPECT_EQ(all.equivalent_sets.size(), 1U);
  EXPECT_EQ(all.invisible.size(), 2U);
  EXPECT_EQ(all.next_experiment, "sweep the frequency; test more lots");
  EXPECT_EQ(all.discrepancies.size(), 2U);
  EXPECT_EQ(all.refitted.size(), 1U);
  EXPECT_EQ(all.extensions.size(), 2U);
  EXPECT_EQ(all.prose, "Friction grows. Lots differ.");
}

TEST(Parts, TheRemainderIsThatOfTheRecordings) {
  Diagnosis diagnosis = host_sim_test::both_parts();
  EXPECT_FALSE(merged(diagnosis).remainder.has_value());
  EXPECT_FALSE(merged(diagnosis).correction.has_value());
  diagnosis.tension->findings.correction = Correction{"travel", 8, 2.4, 1.25};
  EXPECT_EQ(merged(diagnosis).correction->after_N, 1.25);
  diagnosis.tension->findings.remainder = host_sim_test::left_over_position();
  ASSERT_TRUE(merged(diagnosis).remainder.has_value());
  EXPECT_EQ(merged(diagnosis).remainder->covariate, "position");
  EXPECT_EQ(merged(diagnosis).remainder->output_rmse_N, 1.1);
}

TEST(Parts, AMetricOfBothKeepsBothValues) {
  const HeldOutGain gain = merged(host_sim_test::both_parts()).gain;
  EXPECT_EQ(gain.held_out_by, "session, level");
  ASSERT_EQ(gain.metrics.size(), 4U);
  EXPECT_EQ(gain.metrics[1].name, "log_predictive_density");
  EXPECT_EQ(gain.metrics[1].after, 3);
  EXPECT_EQ(gain.metrics[2].name, "lives_log_predictive_density");
  EXPECT_EQ(gain.metrics[2].after, 0.1);
}

TEST(Parts, OfOnePartAloneAreItsOwn) {
  Diagnosis diagnosis;
  diagnosis.lives = host_sim_test::lots_in_lives();
  const Findings all = merged(diagnosis);
  EXPECT_EQ(all.next_experiment, "test more lots");
  EXPECT_EQ(all.gain.metrics[0].name, "log_predictive_density");
}

}  // namespace
}  // namespace host_sim::diagnose
