#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>

#include "host_sim/report/plan/html.hpp"
#include "tests/report/page/page_text.hpp"
#include "tests/report/plan/samples.hpp"

namespace host_sim {
namespace {

using samples::PlanSample;
using testing::HasSubstr;
using testing::Not;

std::string page_of(const PlanSample& sample) {
  std::ostringstream out;
  write_plan_report(out, sample.request, sample.result, sample.courses, "0.1.0");
  return out.str();
}

TEST(PlanPage, IsSelfContained) {
  for (const PlanSample& sample : samples::all_plans()) {
    EXPECT_EQ(page_text::reference_out_of(page_of(sample)), "") << sample.name;
  }
}

TEST(PlanPage, HasAPlaceAndDataForEachPlot) {
  for (const PlanSample& sample : samples::all_plans()) {
    EXPECT_EQ(page_text::misplaced_plot(page_of(sample), sample.charts), "") << sample.name;
  }
}

// B10 at 38 N: 1.53e5 / 38^1.38 (-ln 0.9)^(1 / 5.94) = 1010.6 * 0.68464 = 691.9.
TEST(PlanPage, SaysThePlanInWordsAndNumbers) {
  const std::string found = page_of(samples::all_plans()[0]);
  EXPECT_THAT(found, HasSubstr("<p class=\"verdict\">B10 at 38\u00a0N takes "));
  EXPECT_THAT(found, HasSubstr("<dd class=\"value\">692\u00a0cycles</dd>"));
  EXPECT_THAT(found, HasSubstr("Only 100 campaigns were simulated of each plan."));
  EXPECT_THAT(page_of(samples::all_plans()[1]),
              HasSubstr("No plan of 12\u00a0specimens reaches what is wanted of B10 at 38\u00a0N"));
}

// Three specimens that all fail are fewer than five; two levels fit any curvature.
TEST(PlanPage, WarnsOfFewSpecimensAndOfTwoLevels) {
  const std::string given = page_of(samples::all_plans()[2]);
  EXPECT_THAT(given, HasSubstr("given: 3\u00a0failures expected at 70.8\u00a0N"));
  EXPECT_THAT(given, HasSubstr("2 levels fit any curvature"));
  EXPECT_THAT(given, HasSubstr("Days one by one"));
  EXPECT_THAT(page_of(samples::all_plans()[0]), Not(HasSubstr("Days one by one")));
}

TEST(PlanCharts, StarsLieOnTheLines) {
  const PlanSample& sample = samples::all_plans()[0];
  const Chart chart = plan_page::width_chart(sample.request, sample.result, sample.courses);
  const std::size_t plans = sample.result.tests.size();
  ASSERT_EQ(chart.layers.size(), 2 * plans + 1);
  for (std::size_t i = 0; i < plans; ++i) {
    const Layer& line = chart.layers[i];
    const Layer& star = chart.layers[plans + 1 + i];
    const auto at = std::find(line.x.begin(), line.x.end(), star.x.at(0));
    ASSERT_NE(at, line.x.end()) << line.name;
    EXPECT_EQ(line.y[static_cast<std::size_t>(at - line.x.begin())], star.y.at(0)) << line.name;
  }
  EXPECT_EQ(chart.layers[plans].y, (std::vector<double>{1.5, 1.5}));
}

TEST(PlanCharts, CostIsInDaysWhereTheSpeedOfARigIsKnown) {
  PlanSample sample = samples::all_plans()[0];
  const Chart cycles = plan_page::told_chart(sample.request, sample.result, sample.courses);
  sample.request.cycles_per_minute = 10;
  const Chart days = plan_page::told_chart(sample.request, sample.result, sample.courses);
  EXPECT_EQ(days.x.unit, "days");
  EXPECT_NEAR(days.layers.at(0).x.at(0), cycles.layers.at(0).x.at(0) / 14'400, 1e-12);
}

}  // namespace
}  // namespace host_sim
