#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>
#include <string>

#include "host_sim/report/calibrate/html.hpp"
#include "host_sim/report/calibrate/notation.hpp"
#include "host_sim/report/calibrate/sentences.hpp"
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

namespace host_sim::calibrate_page {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

TEST(Texts, SayWhatANumberCannot) {
  EXPECT_EQ(interval_text({1.25, 3.5}), "1.25 to 3.5");
  EXPECT_EQ(interval_text({-kInfinity, kInfinity}), "no limit to no limit");
}

TEST(Texts, PreferTheSimulatedP) {
  EXPECT_TRUE(calibrate::rejected({4, 1, 0.06, 0.04}));
  EXPECT_FALSE(calibrate::rejected({4, 1, 0.04, 0.06}));
  EXPECT_TRUE(calibrate::rejected({4, 1, 0.04, kNotANumber}));
  EXPECT_FALSE(calibrate::rejected({4, 1, kNotANumber, kNotANumber}));
}

TEST(Verdict, TellsTheLawAndTheFirstUseLevel) {
  calibrate::CalibrateResult result = samples::paper_like();
  result.use_levels[0].mean = 887;
  result.use_levels[0].mean_ci95 = {829, 949};
  result.use_levels[0].b10 = 649;
  result.use_levels[0].b10_ci95 = {607, 695};
  EXPECT_EQ(verdict(result),
            "Life falls with effective tension to the power of 1.46 (95\u00a0% 1.32 to 1.59), with "
            "Weibull shape 5.79; upper arm at 39.9\u00a0N: mean life 887 cycles (829 to 949), B10 "
            "649 (607 to 695). Read the 2 warnings first.");
  result.use_levels.clear();
  result.warnings.pop_back();
  EXPECT_THAT(verdict(result), HasSubstr("shape 5.79. Read the warning first."));
}

TEST(Verdict, SaysThatThereIsNoLaw) {
  calibrate::CalibrateResult result = samples::paper_like();
  result.stress_life.reset();
  EXPECT_THAT(verdict(result), StartsWith("No life law could be fitted"));
}

TEST(Words, TellWhatTheTestsOfTheLawSay) {
  EXPECT_THAT(adequacy_words(samples::paper_like()),
              ElementsAre(StartsWith("The straight line in log-log is not rejected"),
                          StartsWith("No bend of the law in log-log is seen"),
                          StartsWith("Scatter changes with tension")));
}

TEST(Words, DoNotJudgeATestThatWasNotMade) {
  calibrate::CalibrateResult result = samples::paper_like();
  result.stress_life->against_free_levels.reset();
  result.stress_life->against_curvature =
      statistics::Test{kNotANumber, 1, kNotANumber, kNotANumber};
  EXPECT_THAT(adequacy_words(result),
              ElementsAre(HasSubstr("could not be tested"), HasSubstr("could not be tested"),
                          Not(HasSubstr("could not be tested"))));
}

TEST(Words, TellWhetherOneShapeHoldsAndWhoIsLeftOut) {
  const calibrate::CalibrateResult result = samples::paper_like();
  EXPECT_THAT(shape_words(result),
              ElementsAre(HasSubstr("is not rejected (likelihood ratio 6.2 with 3"),
                          HasSubstr("would be rejected (likelihood ratio 15.5 with 4")));
  EXPECT_THAT(left_out_words(result),
              ElementsAre("540 deg, 99.8 N is left out: its shape 3.34 differs from that of the "
                          "other levels, p 0.0023."));
}

/// The share at a height of the Weibull axis.
double share_at(double place) {
  return -std::expm1(-std::exp(place));
}

TEST(ScaleInterval, IsStraightOnProbabilityPaper) {
  // A quarter of the way from -1 to 3: 16 (81/16)^(1/4) = 24 and 1 (16)^(1/4) = 2.
  const auto interval = scale_interval({{share_at(-1), share_at(3)}, {1, 16}, {16, 81}});
  ASSERT_TRUE(interval.has_value());
  EXPECT_NEAR(interval->low, 2, 1e-7);
  EXPECT_NEAR(interval->high, 24, 1e-7);
}

TEST(ScaleInterval, TakesAPointOfTheBandThatIsThere) {
  const auto interval =
      scale_interval({{share_at(-2), share_at(0), share_at(1)}, {1, 5, 9}, {2, 7, 11}});
  ASSERT_TRUE(interval.has_value());
  EXPECT_NEAR(interval->low, 5, 1e-9);
  EXPECT_NEAR(interval->high, 7, 1e-9);
}

TEST(ScaleInterval, NeedsABandThatReachesThere) {
  EXPECT_FALSE(scale_interval({}).has_value());
  EXPECT_FALSE(scale_interval({{share_at(-2), share_at(-1)}, {1, 5}, {2, 7}}).has_value());
}

}  // namespace
}  // namespace host_sim::calibrate_page
