#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "host_sim/report/fmeca/html.hpp"
#include "tests/report/page/page_text.hpp"

namespace host_sim {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string page_of(const fmeca::RiskTable& table, const fmeca::FieldCounts& field = {}) {
  std::ostringstream out;
  write_fmeca_report(out, fmeca::assess(table, field), "0.1.0");
  return out.str();
}

TEST(FmecaPage, IsSelfContained) {
  const std::string page = page_of(fmeca::paper_table());
  EXPECT_EQ(page_text::reference_out_of(page), "");
  EXPECT_EQ(page_text::misplaced_plot(page, 0), "");
}

TEST(FmecaPage, PutsEachModeInItsCellOfTheMatrix) {
  const std::string page = page_of(fmeca::paper_table());
  // Severity 5, occurrence 4: the two of risk 20, the darkest shade; severity 3, occurrence 1: 3.
  EXPECT_THAT(page, HasSubstr("<td class=\"shade-3\"><small>20</small><br><a href=\"#mode-1\" "
                              "title=\"actuator: cable derailment\">1</a> <a href=\"#mode-2\""));
  EXPECT_THAT(page, HasSubstr("<td class=\"shade-0\"><small>3</small><br><a href=\"#mode-14\""));
  EXPECT_EQ(page_text::count_of(page, " id=\"mode-"), 14U);
  EXPECT_EQ(page_text::count_of(page, "<a href=\"#mode-"), 14U);
}

TEST(FmecaPage, TellsWhatNothingWatchesAndWhatIsSeenTooLate) {
  const std::string page = page_of(fmeca::paper_table());
  const std::string blind = page.substr(page.find("What nothing watches"));
  EXPECT_THAT(blind, HasSubstr("<li>soft structure: polymer tear (stress concentration), risk 9"));
  const std::size_t late = blind.find("Seen only when it has failed");
  EXPECT_GT(blind.find("efficiency degradation (abrasion), risk 10"), late);
  EXPECT_THAT(page, Not(HasSubstr("field-heading")));
}

TEST(FmecaPage, TellsFieldRecordsAndRiskPriorityNumbers) {
  fmeca::RiskTable table = fmeca::paper_table();
  for (fmeca::FailureMode& mode : table.modes) {
    mode.detection = 2;
    mode.cause = "<b>";
  }
  const std::string page = page_of(table, {{"wire_fatigue", {4, 7800}}});
  EXPECT_THAT(page, HasSubstr("RPN</th>"));
  EXPECT_THAT(page, HasSubstr("<td class=\"number\">40</td><td class=\"number\">20</td>"));
  EXPECT_THAT(page, HasSubstr("<td class=\"number\">3*</td>"));
  EXPECT_THAT(page, HasSubstr("* From the field"));
  EXPECT_THAT(page, Not(HasSubstr("<b>")));
}

}  // namespace
}  // namespace host_sim
