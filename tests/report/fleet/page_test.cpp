#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "host_sim/report/fleet/html.hpp"
#include "tests/report/fleet/samples.hpp"
#include "tests/report/page/page_text.hpp"

namespace host_sim {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string page_of(const samples::FleetSample& sample) {
  std::ostringstream out;
  write_fleet_report(out, "t<csv", sample.fleet, sample.request, sample.plan, sample.course,
                     "0.1.0");
  return out.str();
}

TEST(FleetPage, IsSelfContained) {
  for (const auto& sample : {samples::typical_fleet(), samples::idle_fleet()}) {
    const std::string page = page_of(sample);
    EXPECT_EQ(page_text::reference_out_of(page), "") << sample.name;
    EXPECT_EQ(page_text::misplaced_plot(page, 2), "") << sample.name;
  }
}

TEST(FleetPage, HasWhatIsToReplace) {
  const std::string page = page_of(samples::typical_fleet());
  EXPECT_THAT(page, HasSubstr("1 of 3\u00a0tendons to replace within 10\u00a0days"));
  const std::size_t table = page.find("aria-label=\"Tendons to replace\"");
  const std::string due = page.substr(table, page.find("</table>", table) - table);
  // At B10, 84.7 hours of ten a day more, and 12.3 % until ten days.
  EXPECT_THAT(due, HasSubstr("old"));
  EXPECT_THAT(due, HasSubstr("2026-03-10"));
  EXPECT_THAT(due, HasSubstr("12.3"));
  EXPECT_THAT(due, Not(HasSubstr("young")));
  EXPECT_THAT(page, HasSubstr("r1/3/&lt;i&gt;"));
  EXPECT_THAT(page, Not(HasSubstr("<b>&")));
  EXPECT_THAT(page, HasSubstr("t&lt;csv"));
}

TEST(FleetPage, HasTheCourseOfSparesAndThePointsOfTendons) {
  const auto data = page_text::data_in(page_of(samples::typical_fleet()));
  const auto& layers = data["charts"]["spares"]["layers"];
  ASSERT_EQ(layers.size(), 4U);
  // On condition it takes one for sure after 8 days, and the old one breaks with 12.3 % until 10.
  EXPECT_EQ(layers[0]["x"].front(), 0);
  EXPECT_EQ(layers[0]["x"].back(), 10);
  EXPECT_EQ(layers[0]["y"].front(), 0);
  EXPECT_EQ(layers[0]["y"].back(), 1);
  // None breaks with 0.877 and 0.969: one spare for 95 %.
  EXPECT_EQ(layers[2]["y"].back(), 1);
  EXPECT_NEAR(layers[3]["y"].back().get<double>(), 0.1232 + 0.0313, 2e-3);
  const auto& points = data["charts"]["risk"]["layers"];
  ASSERT_EQ(points.size(), 3U);
  EXPECT_EQ(points[1]["x"].size(), 2U);
  EXPECT_NEAR(points[2]["y"][0].get<double>(), 12.32, 0.02);
}

TEST(FleetPage, HasCostsWhereThereAreAny) {
  EXPECT_THAT(page_of(samples::typical_fleet()), HasSubstr("What the policies cost"));
  const std::string idle = page_of(samples::idle_fleet());
  EXPECT_THAT(idle, Not(HasSubstr("What the policies cost")));
  EXPECT_THAT(idle, HasSubstr("No tendon is to be replaced until the horizon."));
  EXPECT_THAT(idle, HasSubstr("2000\u00a0hours of operation"));
}

}  // namespace
}  // namespace host_sim
