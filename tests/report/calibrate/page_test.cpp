#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "host_sim/report/calibrate/html.hpp"
#include "tests/report/calibrate/sample_result.hpp"
#include "tests/report/page/page_text.hpp"

namespace host_sim {
namespace {

using page_text::count_of;
using testing::HasSubstr;
using testing::Not;

std::string page_of(const calibrate::CalibrateResult& result) {
  std::ostringstream out;
  write_calibrate_report(out, result, "0.1.0");
  return out.str();
}

TEST(CalibratePage, IsSelfContained) {
  for (const samples::CalibrateSample& sample : samples::all_calibrations()) {
    EXPECT_EQ(page_text::reference_out_of(page_of(sample.result)), "") << sample.name;
  }
}

TEST(CalibratePage, HasAPlaceAndDataForEachPlot) {
  for (const samples::CalibrateSample& sample : samples::all_calibrations()) {
    EXPECT_EQ(page_text::misplaced_plot(page_of(sample.result), sample.charts), "") << sample.name;
  }
}

TEST(CalibratePage, SaysTheVerdictThenTheWarningsThenThePlots) {
  const std::string page = page_of(samples::paper_like());
  const std::size_t verdict = page.find("Life falls with effective tension");
  const std::size_t warnings = page.find("2\u00a0warnings</h2>");
  ASSERT_NE(warnings, std::string::npos);
  EXPECT_LT(verdict, warnings);
  EXPECT_LT(page.find("<li>use level Exo-glove"), page.find("id=\"plots\""));
  EXPECT_LT(warnings, page.find("id=\"plots\""));
  calibrate::CalibrateResult calm = samples::paper_like();
  calm.warnings.clear();
  EXPECT_THAT(page_of(calm), Not(HasSubstr("warnings-heading")));
}

TEST(CalibratePage, HasTheNumbersAsTables) {
  const std::string page = page_of(samples::paper_like());
  for (const char* const row :
       {"<th scope=\"row\">315 deg, 42.5 N</th><td class=\"number\">20</td><td class=\"number\">0"
        "</td><td class=\"number\">854</td>",
        "<th scope=\"row\">270 deg, 35.2 N (validation), Weibull</th><td class=\"number\">0.1</td>"
        "<td class=\"number\">0.95</td><td class=\"number\">0.2</td><td class=\"number\">0.98</td>",
        "<th scope=\"row\">5.94</th><td class=\"number\">5.05 to 6.87</td>",
        "<th scope=\"row\">of the life law</th><td class=\"number\">6.2</td><td class=\"number\">3"
        "</td><td class=\"number\">0.1</td><td class=\"number\">0.12</td>",
        "<th scope=\"row\">Exponent gamma</th><td class=\"number\">1.457</td><td class=\"number\">"
        "1.32 to 1.59</td><td class=\"number\">1.38</td>",
        "<th scope=\"row\">270 deg, 35.2 N</th><td class=\"number\">1044</td><td class=\"number\">"
        "993</td><td class=\"number\">0.86 to 1.05</td><td class=\"number\">0.31</td>",
        "<td>45.11\u00a0N</td><td>44.34\u00a0N</td>"}) {
    EXPECT_THAT(page, HasSubstr(row));
  }
}

TEST(CalibratePage, SaysInWordsWhatIsMissing) {
  for (const samples::CalibrateSample& sample : samples::all_calibrations()) {
    const std::string page = page_of(sample.result);
    const std::string body = page.substr(page.find("<main>"), page.find("</main>"));
    for (const char* const leak : {">nan<", ">inf<", "-nan", "unlimited", "{{"}) {
      if (sample.name != "hostile") {
        EXPECT_EQ(count_of(body.substr(0, body.find("</main>")), leak), 0U)
            << sample.name << ' ' << leak;
      }
    }
  }
  EXPECT_THAT(page_of({}), HasSubstr("No life law could be fitted to this campaign."));
  for (const samples::CalibrateSample& sample : samples::all_calibrations()) {
    if (sample.name == "without_law") {
      EXPECT_THAT(page_of(sample.result), HasSubstr(">fewer than two failures</td>"));
    }
  }
}

TEST(CalibratePage, NoTextLeavesItsPlace) {
  const std::string tame = page_of(samples::paper_like());
  const std::string page = page_of(samples::hostile_campaign());
  for (const char* const piece : {"<script", "</script", "<style", "<img", "<!--", "-->"}) {
    EXPECT_EQ(count_of(page, piece), count_of(tame, piece)) << piece;
  }
  EXPECT_THAT(page, Not(HasSubstr("<plaintext")));
  EXPECT_THAT(page, Not(HasSubstr("onclick='throw")));
  EXPECT_THAT(page, Not(HasSubstr("\xff")));
  EXPECT_THAT(page, HasSubstr("{{title}} Überlast 腕 \ufffd"));
}

TEST(CalibratePage, IsTheSameForTheSameResult) {
  EXPECT_EQ(page_of(samples::paper_like()), page_of(samples::paper_like()));
}

}  // namespace
}  // namespace host_sim
