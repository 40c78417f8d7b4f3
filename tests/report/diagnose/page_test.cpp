#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "host_sim/report/diagnose/html.hpp"
#include "host_sim/report/diagnose/tables.hpp"
#include "tests/report/diagnose/sample_diagnosis.hpp"
#include "tests/report/page/page_text.hpp"

namespace host_sim {
namespace {

using page_text::count_of;
using testing::HasSubstr;
using testing::Not;

std::string page_of(const diagnose::Diagnosis& diagnosis, const std::string& campaign = "test") {
  std::ostringstream out;
  write_diagnose_report(out, campaign, diagnosis, "0.1.0");
  return out.str();
}

std::string page_of(const samples::DiagnosisSample& sample) {
  return page_of(sample.diagnosis, sample.campaign);
}

TEST(DiagnosisPage, IsSelfContained) {
  for (const samples::DiagnosisSample& sample : samples::all_diagnoses()) {
    EXPECT_EQ(page_text::reference_out_of(page_of(sample)), "") << sample.name;
  }
}

TEST(DiagnosisPage, HasAPlaceAndDataForEachPlot) {
  for (const samples::DiagnosisSample& sample : samples::all_diagnoses()) {
    EXPECT_EQ(page_text::misplaced_plot(page_of(sample), sample.charts), "") << sample.name;
  }
}

TEST(DiagnosisPage, SaysTheVerdictThenTheWarningsThenTheParts) {
  const std::string page = page_of(samples::both_named());
  const std::size_t verdict = page.find("<p class=\"verdict\">Recordings: the model leaves out");
  const std::size_t warnings = page.find("1\u00a0warning</h2>");
  const std::size_t recordings = page.find("Recordings: what was found</h2>");
  const std::size_t lives = page.find("Lives: what was found</h2>");
  ASSERT_NE(verdict, std::string::npos);
  ASSERT_NE(lives, std::string::npos);
  EXPECT_LT(verdict, warnings);
  EXPECT_LT(warnings, recordings);
  EXPECT_LT(recordings, lives);
}

TEST(DiagnosisPage, HasTheNumbersAsTables) {
  const std::string page = page_of(samples::both_named());
  for (const char* const row :
       {"<th scope=\"row\">friction_wear, wear_coefficient</th><td class=\"number\">0.152</td>"
        "<td class=\"number\">0.139 to 0.166</td>",
        "<th scope=\"row\">error of the output tension (RMSE)</th><td class=\"number\">low</td>"
        "<td class=\"number\">1.21\u00a0N</td><td class=\"number\">0.31\u00a0N</td>"
        "<td class=\"number\">\u221274.4\u00a0%</td><td class=\"number\">yes</td>",
        "<th scope=\"row\">log predictive density</th><td class=\"number\">high</td>"
        "<td class=\"number\">2.04</td><td class=\"number\">3.12</td>"
        "<td class=\"number\">+1.08</td><td class=\"number\">yes</td>",
        "<th scope=\"row\">specimens broken before their B10</th><td class=\"number\">0.1</td>"
        "<td class=\"number\">0.21</td><td class=\"number\">0.1</td>"
        "<td class=\"number\">\u22120.11</td><td class=\"number\">yes</td>",
        "<th scope=\"row\">cycle</th><td class=\"number\">9.8</td><td class=\"number\">below 0.001"
        "</td><td class=\"number\">0.41</td>",
        "<th scope=\"row\">torque_ripple</th>", "<th scope=\"row\">compliance, filter_lag</th>",
        "<td>change the frequency at the same speed</td>",
        "<th scope=\"row\">ipl_scale</th><td class=\"number\">201\u202f000\u00a0cycles</td>"}) {
    EXPECT_THAT(page, HasSubstr(row));
  }
}

TEST(DiagnosisPage, TellsTheCostInLife) {
  const std::string page = page_of(samples::both_named());
  EXPECT_THAT(page, HasSubstr("computes 0.88 times the damage of the extended one, and so predicts "
                              "1.14 times the life."));
  EXPECT_THAT(page, HasSubstr("predicts 1.31 times the B10 of the extended one."));
  EXPECT_THAT(page_of(samples::nothing_wrong()), HasSubstr("Nothing was extended"));
}

TEST(DiagnosisPage, SaysWhatRemainsBesideTheVerdict) {
  const std::string page = page_of(samples::outside_of_catalogue());
  EXPECT_THAT(page, HasSubstr("What remains"));
  EXPECT_THAT(page, HasSubstr("12\u00a0%"));
  EXPECT_THAT(page,
              HasSubstr("of the squared error of the nominal model, 2.4\u00a0N of input tension, "
                        "1.1\u00a0N of output tension, most against travel since reversal "
                        "(p 0.005)"));
  EXPECT_LT(page.find("What remains"), page.find("Zero of the load cell of the rig"));
  EXPECT_THAT(page_of(samples::wear_named()), Not(HasSubstr("of the squared error of")));
}

TEST(DiagnosisPage, AnEffectOutsideOfTheCatalogueHasItsOwnTerm) {
  const std::string page = page_of(samples::outside_of_catalogue());
  EXPECT_THAT(page, HasSubstr("the model leaves out zero of the load cell of the rig (99"));
  EXPECT_THAT(page, HasSubstr("zero_of_rig<br><small>zero of the load cell of the rig</small>"));
  EXPECT_THAT(page,
              HasSubstr("<small>backlash or dead zone and zero of the load cell of the rig<"));
  EXPECT_THAT(page, HasSubstr("<td>backlash or dead zone, zero of the load cell of the rig</td>"));
  EXPECT_THAT(page, HasSubstr("none: the tendon does not see it"));
  EXPECT_THAT(page, HasSubstr("<th scope=\"row\">never_heard_of</th>"));
}

TEST(DiagnosisPage, NamesTheExperimentThatDecides) {
  EXPECT_THAT(page_of(samples::ambiguous_pair()),
              HasSubstr("<strong>Experiment to make next.</strong> record at several bend angles"));
  EXPECT_THAT(page_of(samples::wear_named()), Not(HasSubstr("Experiment to make next")));
}

TEST(DiagnosisPage, SaysInWordsWhatIsMissing) {
  for (const samples::DiagnosisSample& sample : samples::all_diagnoses()) {
    const std::string page = page_of(sample);
    const std::string body = page.substr(page.find("<main>"), page.find("</main>"));
    for (const char* const leak : {">nan<", ">inf<", "-nan", "{{"}) {
      if (sample.name != "hostile") {
        EXPECT_EQ(count_of(body.substr(0, body.find("</main>")), leak), 0U)
            << sample.name << ' ' << leak;
      }
    }
  }
  EXPECT_THAT(page_of(diagnose::Diagnosis()), HasSubstr("There was nothing to diagnose."));
}

TEST(DiagnosisPage, HasTheGainBesideTheStepsOfTheCatalogue) {
  diagnose::Diagnosis diagnosis = samples::explained_in_part();
  EXPECT_THAT(page_of(diagnosis), HasSubstr("which it does not: nothing is named."));
  EXPECT_THAT(page_of(diagnosis), HasSubstr("<th scope=\"row\">+ friction_position</th>"));
  const diagnose::Findings named = samples::wear_named().tension->findings;
  diagnosis.tension->findings.effects = named.effects;
  diagnosis.tension->findings.gain = named.gain;
  const std::string page = page_of(diagnosis);
  EXPECT_THAT(page, Not(HasSubstr("nothing is named")));
  EXPECT_THAT(page, HasSubstr("<th scope=\"row\">+ friction_position</th>"));
  EXPECT_THAT(page, HasSubstr("<th scope=\"row\">log predictive density</th>"));
}

TEST(DiagnosisPage, NoTextLeavesItsPlace) {
  const std::string tame = page_of(samples::both_named());
  for (const samples::DiagnosisSample& sample : samples::all_diagnoses()) {
    if (sample.name != "hostile") {
      continue;
    }
    const std::string page = page_of(sample);
    for (const char* const piece : {"<script", "</script", "<style", "<img", "<!--", "-->"}) {
      EXPECT_EQ(count_of(page, piece), count_of(tame, piece)) << piece;
    }
    EXPECT_THAT(page, Not(HasSubstr("<plaintext")));
    EXPECT_THAT(page.substr(0, page.find("id=\"page-data\"")), Not(HasSubstr("onclick='throw")));
    EXPECT_THAT(page, Not(HasSubstr("\xff")));
    EXPECT_THAT(page, HasSubstr("{{title}} &amp;lt; Überlast 腕 \ufffd"));
  }
}

TEST(DiagnosisPage, IsTheSameForTheSameDiagnosis) {
  EXPECT_EQ(page_of(samples::both_named()), page_of(samples::both_named()));
}

TEST(Ranking, PutsTheMostProbableFirstAndTheRestTogether) {
  diagnose::Findings findings;
  findings.candidates = {
      {"slack", 0.2}, {"unknown", 0.799}, {"compliance", 0.0006}, {"none", 0.0004}};
  findings.credible_set = {"unknown", "slack"};
  const std::string html = diagnose_page::tables::ranking(findings);
  EXPECT_LT(html.find(">unknown<"), html.find(">slack<"));
  EXPECT_EQ(count_of(html, "class=\"strong\""), 2U);
  EXPECT_EQ(count_of(html, "class=\"weak\""), 1U);
  EXPECT_THAT(html, HasSubstr("2\u00a0other candidates<br><small>together</small>"));
  EXPECT_THAT(html, HasSubstr("<td class=\"number\">0.1\u00a0%</td>"));
  EXPECT_THAT(html, HasSubstr("class=\"strong\" width=\"79.90\""));
  findings.candidates[3].probability = 0.0001;
  EXPECT_THAT(diagnose_page::tables::ranking(findings),
              HasSubstr("<td class=\"number\">below 0.1\u00a0%</td>"));
  EXPECT_EQ(diagnose_page::tables::ranking({}), "");
}

}  // namespace
}  // namespace host_sim
