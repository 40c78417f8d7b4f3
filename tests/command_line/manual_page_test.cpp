#include "host_sim/command_line/manual_page.hpp"

#include <gtest/gtest.h>

#include "tests/command_line/small_program.hpp"

namespace {

using namespace host_sim::command_line;

class ManualPage : public testing::Test {
 protected:
  void expect(const std::string& part) const {
    EXPECT_NE(page_.find(part), std::string::npos) << part << "\nis not in\n" << page_;
  }

  host_sim_test::SmallProgram small_;
  std::string page_ =
      manual_page(read_command(small_.app), {"1.2", "2026-11-22"},
                  {"Text.\n", ".SH FILES\nNone.\n", ".BR cat (1)\n"}, "there", "/usr/share/there");
};

TEST_F(ManualPage, BeginsAsManWantsIt) {
  expect(".TH GEAR-BOX 1 \"2026-11-22\" \"tendonlife 1.2\" \"User Commands\"\n");
  expect(".SH NAME\ngear\\-box \\- Makes gears\n");
}

TEST_F(ManualPage, HasTheSectionsInTheirUsualOrder) {
  std::size_t at = 0;
  for (const char* section :
       {"NAME", "SYNOPSIS", "DESCRIPTION", "OPTIONS", "VERBS", "FILES", "EXAMPLES", "SEE ALSO"}) {
    const std::size_t found = page_.find(std::string(".SH ") + section + "\n");
    ASSERT_NE(found, std::string::npos) << section;
    EXPECT_GT(found, at) << section;
    at = found;
  }
}

TEST_F(ManualPage, SynopsisOfAVerbHasWhatItNeeds) {
  expect(
      ".SS cut\nCuts one [slowly]: it's exact.\n.PP\n"
      "\\fBcut\\fR \\fB\\-o\\fR, \\fB\\-\\-out\\fR \\fIFOLDER\\fR [\\fIoptions\\fR] "
      "\\fIBLANK\\fR\n");
}

TEST_F(ManualPage, AnOptionHasItsValueItsLimitsAndItsPreset) {
  expect(
      ".TP\n\\fB\\-\\-depth\\fR \\fINUMBER\\fR\nHow deep.\nAccepted: 0.5 to 4.\nWithout it: "
      "\\fB2.5\\fR.\n");
  expect("Which.\nOne of: \\fBsteel\\fR, \\fBbrass\\fR.\n");
  expect("What to look at.\nAny of, between commas: \\fBteeth\\fR, \\fBbore\\fR.\n");
  expect("Whom.\nThe variable \\fBGEAR_TO\\fR does the same.\n");
}

TEST_F(ManualPage, AVerbOfAVerbIsNamedByBoth) {
  expect(
      ".SS sell many\nSells many.\n.PP\n\\fBsell many\\fR [\\fIoptions\\fR] "
      "\\fIGEAR\\fR...\n");
  EXPECT_EQ(page_.find(".SS sell\n"), std::string::npos);
}

TEST_F(ManualPage, HelpIsToldOnce) {
  const std::size_t first = page_.find("\n\\fB\\-h\\fR, \\fB\\-\\-help\\fR\n");
  ASSERT_NE(first, std::string::npos);
  EXPECT_EQ(page_.find("\n\\fB\\-h\\fR, ", first + 1), std::string::npos);
}

TEST_F(ManualPage, ExamplesAreThoseOfAnInstalledProgram) {
  expect(
      ".SH EXAMPLES\n.EX\ngear\\-box cut a.bar \\-\\-out /usr/share/there\n.EE\n.PP\n.EX\n"
      "gear\\-box cut b.bar\n.EE\n");
}

TEST(Roff, NothingInATextIsARequestOrAnEscape) {
  EXPECT_EQ(roff_text(".TH at the front"), "\\&.TH at the front");
  EXPECT_EQ(roff_text("'tis"), "\\&'tis");
  EXPECT_EQ(roff_text("a\\fBb"), "a\\efBb");
}

TEST(Roff, ADashBeforeAWordIsThatOfACommandLine) {
  EXPECT_EQ(roff_text("- is input; two-level; --json -"),
            "\\- is input; two-level; \\-\\-json \\-");
  EXPECT_EQ(roff_literal("left-out"), "left\\-out");
}

}  // namespace
