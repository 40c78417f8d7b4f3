#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "host_sim/diagnose/diagnosis.hpp"
#include "tests/diagnose/lives/scenario.hpp"

namespace host_sim::diagnose {
namespace {

using host_sim::test::Scenario;
using host_sim::test::simulated;

LifeDiagnosis diagnosis_of(const Scenario& scenario, std::vector<std::string> without = {}) {
  LifeDiagnosis diagnosis =
      diagnose_lives(simulated(scenario), {.seed = 1, .without = std::move(without)});
  double sum = 0;
  for (const Candidate& candidate : diagnosis.findings.candidates) {
    sum += candidate.probability;
  }
  EXPECT_NEAR(sum, 1, 1e-9);
  return diagnosis;
}

TEST(DiagnoseLives, NamesAnEnduranceLimit) {
  const LifeDiagnosis diagnosis = diagnosis_of({96, "endurance_limit", 2});
  const Findings& findings = diagnosis.findings;
  ASSERT_EQ(findings.verdict, Verdict::named);
  ASSERT_EQ(findings.effects.size(), 1U);
  EXPECT_EQ(findings.effects[0].id, "endurance_limit");
  EXPECT_GE(findings.effects[0].probability, kNamed);
  ASSERT_EQ(findings.extensions.size(), 1U);
  EXPECT_EQ(findings.extensions[0].id, "endurance_limit");
  ASSERT_EQ(findings.extensions[0].values.size(), 4U);
  EXPECT_EQ(findings.extensions[0].values[3].name, "lowest_effective_N");
  EXPECT_NEAR(findings.extensions[0].values[3].values.at(0), 22.9, 0.1);
  EXPECT_EQ(findings.gain.held_out_by, "level");
  EXPECT_GT(findings.gain.metrics.at(0).after, findings.gain.metrics.at(0).before);
  EXPECT_EQ(diagnosis.picture.points.size(), 96U);
  EXPECT_GT(diagnosis.picture.shape_after, diagnosis.picture.shape_before);
}

/// Its header says so: a limit of 20 N with a logarithmic standard deviation of 0.1.
TEST(DiagnoseLives, NamesTheLimitOfTheExample) {
  std::ifstream file(TENDONLIFE_EXAMPLE "/../synth/lives.toml");
  std::stringstream text;
  text << file.rdbuf();
  const Findings findings = diagnose_lives(simulated(text.str(), 1), {.without = {}}).findings;
  ASSERT_EQ(findings.verdict, Verdict::named) << findings.prose;
  ASSERT_EQ(findings.effects.size(), 1U);
  EXPECT_EQ(findings.effects[0].id, "endurance_limit");
  const Estimate& log_sd = findings.effects[0].parameters.at(0);
  EXPECT_LT(log_sd.low, 0.1);
  EXPECT_GT(log_sd.high, 0.1);
  const Estimate& of_lowest = findings.effects[0].parameters.at(1);
  EXPECT_LT(of_lowest.low, 20 / 30.8);
  EXPECT_GT(of_lowest.high, 20 / 30.8);
}

TEST(DiagnoseLives, ParametersOfLotsHoldTheTruth) {
  // log_sd of seed 20003 is drawn from 0.1 .. 0.4.
  const LifeDiagnosis diagnosis = diagnosis_of({48, "lot_frailty", 20003});
  ASSERT_EQ(diagnosis.findings.verdict, Verdict::named);
  const Estimate& log_sd = diagnosis.findings.effects.at(0).parameters.at(0);
  EXPECT_EQ(log_sd.name, "lot_log_sd");
  EXPECT_LT(log_sd.low, log_sd.value);
  EXPECT_GT(log_sd.high, log_sd.value);
}

TEST(DiagnoseLives, NothingHiddenIsNone) {
  const LifeDiagnosis diagnosis = diagnosis_of({96, "none", 20010});
  EXPECT_EQ(diagnosis.findings.verdict, Verdict::none);
  EXPECT_TRUE(diagnosis.findings.extensions.empty());
  EXPECT_EQ(diagnosis.b10_ratio, 1);
  // The law that the lives were drawn from.
  EXPECT_NEAR(diagnosis.ipl_exponent, 1.38, 0.25);
  EXPECT_NEAR(diagnosis.weibull_shape, 5.94, 2);
}

TEST(DiagnoseLives, WhatIsOutsideIsUnknown) {
  for (const char* hidden : {"rig_bias", "early_deaths"}) {
    const LifeDiagnosis diagnosis = diagnosis_of({96, hidden, 20006});
    EXPECT_EQ(diagnosis.findings.verdict, Verdict::unknown) << hidden;
    EXPECT_EQ(diagnosis.findings.candidates.front().id, "unknown") << hidden;
  }
}

TEST(DiagnoseLives, AnEffectThatIsNotInTheCatalogueIsUnknownAndNotAnother) {
  for (const char* hidden : {"lot_frailty", "ageing"}) {
    const LifeDiagnosis diagnosis = diagnosis_of({48, hidden, 20003}, {hidden});
    EXPECT_NE(diagnosis.findings.verdict, Verdict::named) << hidden;
    EXPECT_EQ(diagnosis.findings.verdict, Verdict::unknown) << hidden;
  }
}

TEST(DiagnoseLives, DoesNotDependOnThreads) {
  const Campaign campaign = simulated({24, "ageing", 20011});
  const LifeDiagnosis one = diagnose_lives(campaign, {.seed = 5, .threads = 1, .without = {}});
  const LifeDiagnosis three = diagnose_lives(campaign, {.seed = 5, .threads = 3, .without = {}});
  ASSERT_EQ(one.findings.candidates.size(), three.findings.candidates.size());
  for (std::size_t i = 0; i < one.findings.candidates.size(); ++i) {
    EXPECT_EQ(one.findings.candidates[i].id, three.findings.candidates[i].id);
    EXPECT_EQ(one.findings.candidates[i].probability, three.findings.candidates[i].probability);
  }
  EXPECT_EQ(one.findings.prose, three.findings.prose);
  EXPECT_EQ(one.b10_ratio, three.b10_ratio);
}

}  // namespace
}  // namespace host_sim::diagnose
