#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>

#include "host_sim/report/compare/html.hpp"
#include "tests/report/compare/samples.hpp"
#include "tests/report/page/page_text.hpp"

namespace host_sim {
namespace {

using testing::DoubleEq;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

std::string page_of(const compare::Comparison& comparison) {
  std::ostringstream out;
  write_compare_report(out, comparison, "0.1.0");
  return out.str();
}

Chart chart_of(const compare::Comparison& comparison, const std::string& id) {
  const std::vector<Chart> charts = compare_charts(comparison);
  return *std::ranges::find(charts, id, &Chart::id);
}

TEST(ComparePage, IsSelfContained) {
  for (const samples::ComparisonSample& sample : samples::all_comparisons()) {
    const std::string page = page_of(sample.comparison);
    EXPECT_EQ(page_text::reference_out_of(page), "") << sample.name;
    EXPECT_EQ(page_text::misplaced_plot(page, sample.charts), "") << sample.name;
    EXPECT_THAT(page, Not(HasSubstr("<b>"))) << sample.name;
  }
}

TEST(ComparePage, HasWhatDiffersBetweenModels) {
  const std::string page = page_of(samples::all_comparisons()[0].comparison);
  EXPECT_THAT(page, HasSubstr("<th scope=\"row\">sheath.friction_coefficient</th><td "
                              "class=\"number\">0.128</td><td class=\"number\">0.15</td><td "
                              "class=\"number\">\u00d7\u00a00.8</td>"));
  EXPECT_THAT(page, HasSubstr("<td class=\"number\">none</td><td class=\"number\">9</td><td "
                              "class=\"number\">not known</td>"));
  // 0.03 of 0.02.
  EXPECT_THAT(page, HasSubstr("<th scope=\"row\">Life used</th><td class=\"number\">0.02</td><td "
                              "class=\"number\">0.03</td><td class=\"number\">\u00d7\u00a01.5"));
  EXPECT_THAT(page, HasSubstr("apart by more than 1\u00a0% after 30\u00a0s"));
}

TEST(ComparePage, HasWhatDiffersBetweenProfiles) {
  const std::string page = page_of(samples::all_comparisons()[1].comparison);
  EXPECT_THAT(page, HasSubstr("at 30 s: A line 3 with 60 N, B line 4 with 50 N."));
  EXPECT_THAT(page, HasSubstr("<li>B, new.csv: the wire hangs loose</li>"));
  EXPECT_THAT(page, HasSubstr("never apart"));
}

TEST(ComparePage, AddsDamageOfTheSameRange) {
  const Chart chart = chart_of(samples::all_comparisons()[0].comparison, "classes");
  ASSERT_EQ(chart.layers.size(), 4U);
  const Layer& stairs = chart.layers[2];  // of B: 0.001 from 8 to 12 N, 0.029 from 48 to 52 N
  EXPECT_THAT(stairs.x, ElementsAre(0, 8, 8, 12, 12, 48, 48, 52, 52));
  EXPECT_THAT(stairs.y, ElementsAre(0, 0, 1e-3, 1e-3, 0, 0, 0.029, 0.029, 0));
  EXPECT_THAT(chart.layers[1].x, ElementsAre(50)) << "A has no damage in the lower class";
  EXPECT_THAT(chart.layers[3].x, ElementsAre(10, 50));
}

TEST(ComparePage, DrawsALongProfileFromLowToHighOverHours) {
  const Chart chart = chart_of(samples::all_comparisons()[1].comparison, "tension");
  EXPECT_EQ(chart.x.unit, "h");
  EXPECT_THAT(chart.layers[1].x, ElementsAre(0, 0, DoubleEq(5000. / 3600), DoubleEq(5000. / 3600),
                                             DoubleEq(10000. / 3600), DoubleEq(10000. / 3600)));
  EXPECT_THAT(chart.layers[1].y, ElementsAre(9, 58, 10, 60, 11, 62));
}

}  // namespace
}  // namespace host_sim
