#include <gtest/gtest.h>

#include "host_sim/report/diagnose/head.hpp"
#include "tests/report/diagnose/sample_diagnosis.hpp"

namespace host_sim::diagnose_page {
namespace {

TEST(DiagnosisVerdict, NamesTheEffectInTheWordsOfTheField) {
  EXPECT_EQ(verdict(samples::wear_named()),
            "Recordings: the model leaves out wear or run-in of the sheath (98.7\u00a0%).");
}

TEST(DiagnosisVerdict, ListsTwoEffects) {
  diagnose::Diagnosis diagnosis = samples::wear_named();
  auto& effects = diagnosis.tension->findings.effects;
  effects.push_back(effects.front());
  effects.back().term = "backlash";
  effects.back().probability = 0.96;
  EXPECT_EQ(verdict(diagnosis),
            "Recordings: the model leaves out wear or run-in of the sheath (98.7\u00a0%) and "
            "backlash (96\u00a0%).");
}

TEST(DiagnosisVerdict, SaysWhatIsAmbiguousByTheCredibleSet) {
  const std::string text = verdict(samples::ambiguous_pair());
  EXPECT_NE(text.find("do not determine the cause"), std::string::npos);
  EXPECT_NE(text.find(" or "), std::string::npos);
  EXPECT_EQ(text.find("98.7"), std::string::npos);
}

TEST(DiagnosisVerdict, TakesTheTermOfTheEffectWhereTheCatalogueHasNone) {
  diagnose::Diagnosis diagnosis = samples::outside_of_catalogue();
  diagnosis.tension->findings.verdict = diagnose::Verdict::ambiguous;
  diagnosis.tension->findings.credible_set = {"zero_of_rig", "never_heard_of"};
  EXPECT_NE(verdict(diagnosis).find(": zero of the load cell of the rig or never_heard_of."),
            std::string::npos);
  diagnosis = samples::unexplained();
  diagnosis.tension->findings.steps.resize(2);
  diagnosis.tension->findings.steps[1].effect.id = "zero_of_rig";
  EXPECT_NE(verdict(diagnosis).find("in part, by zero_of_rig."), std::string::npos);
}

TEST(DiagnosisVerdict, NothingAndUnknownAreNotTheSame) {
  EXPECT_EQ(verdict(samples::nothing_wrong()),
            "Recordings: the campaign shows no discrepancy from the model.");
  EXPECT_EQ(verdict(samples::unexplained()),
            "Recordings: the model does not fit, and nothing in the catalogue explains why.");
  EXPECT_EQ(verdict({}), "There was nothing to diagnose.");
}

TEST(DiagnosisVerdict, EachPartHasItsSentence) {
  const std::string text = verdict(samples::both_named());
  EXPECT_LT(text.find("Recordings: "), text.find(" Lives: the model leaves out batch-to-batch"));
}

TEST(DiagnosisOrigin, CountsTheSpecimens) {
  EXPECT_NE(origin(samples::lots_named()).find("the lives of 48\u00a0specimens"),
            std::string::npos);
  EXPECT_EQ(origin({}), "The campaign holds neither recordings nor lives.");
}

}  // namespace
}  // namespace host_sim::diagnose_page
