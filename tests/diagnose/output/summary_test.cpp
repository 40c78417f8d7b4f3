#include "host_sim/diagnose/output/summary.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "tests/diagnose/output/hand_made_diagnosis.hpp"

namespace host_sim::diagnose {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

std::string summary_of(const Diagnosis& diagnosis, std::string_view campaign = "crossed") {
  std::ostringstream out;
  write_summary(out, campaign, diagnosis);
  return out.str();
}

TEST(DiagnosisSummary, TellsAllOfAPart) {
  Diagnosis diagnosis;
  diagnosis.tension = host_sim_test::wear_in_recordings();
  diagnosis.warnings = {"session s4: saturated"};
  EXPECT_EQ(summary_of(diagnosis),
            "crossed: named\n"
            "recordings: named\n"
            "  Friction grows.\n"
            "  friction_wear         probability 0.987  wear of the sheath\n"
            "    wear_coefficient          0.152  (95 %: 0.139 .. 0.166)\n"
            "  refitted friction_coefficient      0.131  (95 %: 0.127 .. 0.135)\n"
            "  improvement on data that the fit did not use, held out by session\n"
            "    error of the output tension (RMSE)  1.5 -> 0.5 N\n"
            "    log predictive density              2 -> 3\n"
            "  cost in life: In the geometric mean over recordings the nominal model computes 0.8 "
            "times the "
            "damage of the extended one, and so predicts 1.25 times the life.\n"
            "  not distinguishable here: compliance, filter_lag; to distinguish them: change the "
            "frequency "
            "at the same speed\n"
            "  not detectable here: torque_ripple: record the motor angle\n"
            "  next experiment: sweep the frequency\n"
            "warning: session s4: saturated\n");
}

TEST(DiagnosisSummary, TellsTheCandidatesWhereNoneIsNamed) {
  Diagnosis diagnosis;
  diagnosis.tension = host_sim_test::wear_in_recordings();
  EXPECT_THAT(summary_of(diagnosis), Not(HasSubstr(": probability")));
  Findings& findings = diagnosis.tension->findings;
  findings.verdict = Verdict::ambiguous;
  findings.effects.clear();
  findings.candidates = {{"slack", 0.6}, {"compliance+slack", 0.399}, {"none", 0.001}};
  EXPECT_THAT(
      summary_of(diagnosis),
      HasSubstr(
          "  slack: probability 0.600\n  compliance and slack: probability 0.399\n  refitted"));
}

TEST(DiagnosisSummary, SaysWhereTheExtensionIsNoBetter) {
  Diagnosis diagnosis;
  diagnosis.lives = host_sim_test::lots_in_lives();
  diagnosis.lives->findings.gain.metrics = {{"b10_coverage", 0.1, 0.2}};
  EXPECT_THAT(summary_of(diagnosis), HasSubstr("0.1 -> 0.2  (not better)\n"));
}

TEST(DiagnosisSummary, ReportsWhatRemains) {
  Diagnosis diagnosis;
  diagnosis.tension = host_sim_test::wear_in_recordings();
  EXPECT_THAT(summary_of(diagnosis), Not(HasSubstr("remains:")));
  diagnosis.tension->findings.remainder = host_sim_test::left_over_position();
  EXPECT_THAT(summary_of(diagnosis),
              HasSubstr("\n  remains: 12 % of the squared error, 2.4 N of input tension, most "
                        "against position (p 0.005)\n  cost in life"));
}

TEST(DiagnosisSummary, AnEffectOutsideOfTheCatalogueHasItsOwnTerm) {
  Diagnosis diagnosis;
  diagnosis.tension = host_sim_test::zero_of_rig();
  EXPECT_THAT(summary_of(diagnosis),
              HasSubstr("  zero_of_rig           probability 0.990  zero of the rig\n"));
  EXPECT_THAT(summary_of(diagnosis), HasSubstr("not distinguishable here: slack, zero_of_rig\n"));
}

TEST(DiagnosisSummary, NamesDoNotMoveTheTerminal) {
  Diagnosis diagnosis = host_sim_test::both_parts();
  diagnosis.tension->findings.prose = "\x1b[2J";
  diagnosis.tension->findings.effects[0].id = "\x1b]0;";
  diagnosis.warnings = {"a\rb\nc"};
  const std::string text = summary_of(diagnosis, "c\x1b[1m");
  EXPECT_EQ(text.find('\x1b'), std::string::npos);
  EXPECT_EQ(text.find('\r'), std::string::npos);
  EXPECT_THAT(text, HasSubstr("warning: a\\rb\\nc\n"));
}

TEST(DiagnosisSummary, AValueWithoutAnIntervalStandsAlone) {
  Diagnosis diagnosis;
  diagnosis.lives = host_sim_test::lots_in_lives();
  diagnosis.lives->findings.refitted = {{"rig_sd", "N", 0.5, 0.5, 0.5}};
  EXPECT_THAT(summary_of(diagnosis), HasSubstr("  refitted rig_sd                    0.5 N\n"));
}

TEST(DiagnosisSummary, OfNothing) {
  EXPECT_EQ(summary_of({}, "empty"), "empty: none\n");
}

TEST(DiagnosisSummary, BothPartsInTheirOrder) {
  const std::string text = summary_of(host_sim_test::both_parts());
  EXPECT_THAT(text, StartsWith("crossed: named\nrecordings: named\n"));
  EXPECT_THAT(text, HasSubstr("\nlives: named\n  Lots differ.\n"));
  EXPECT_THAT(text, HasSubstr("the nominal model predicts 1.25 times the B10"));
}

}  // namespace
}  // namespace host_sim::diagnose
