#include "tests/verbs/campaign_program.hpp"

namespace host_sim_test {
namespace {

class HelpProgram : public CampaignProgram {
 protected:
  void expect_complaint(const std::string& command, const std::string& line) {
    EXPECT_EQ(run(command), 2) << command;
    EXPECT_EQ(err_, line + "\nRun with --help for more information.\n") << command;
    EXPECT_EQ(out_, "") << command;
  }

  std::string last_line() const {
    const std::string text = out_.substr(0, out_.size() - 1);
    return text.substr(text.rfind('\n') + 1);
  }
};

TEST_F(HelpProgram, IsTheHelpOfTheVerb) {
  for (const std::string verb : {"", "replay", "import", "import columns", "help"}) {
    ASSERT_EQ(run(verb + " --help"), 0) << err_;
    const std::string expected = out_;
    EXPECT_EQ(run("help " + verb), 0) << err_;
    EXPECT_EQ(out_, expected) << verb;
  }
}

TEST_F(HelpProgram, AMisspeltVerbHasItsNearest) {
  expect_complaint("replya good.csv --model model.toml",
                   "'replya' is no verb of host_sim; did you mean 'replay'?");
  expect_complaint("dignose c", "'dignose' is no verb of host_sim; did you mean 'diagnose'?");
  expect_complaint("calib c", "'calib' is no verb of host_sim; did you mean 'calibrate'?");
  expect_complaint("import davnci good.csv",
                   "'davnci' is no verb of import; did you mean 'davinci'?");
  expect_complaint("help planes", "'planes' is no verb of host_sim; did you mean 'plan'?");
  expect_complaint("help import colums", "'colums' is no verb of import; did you mean 'columns'?");
}

TEST_F(HelpProgram, AMisspeltOptionHasItsNearest) {
  expect_complaint("replay good.csv --modle model.toml",
                   "replay has no option '--modle'; did you mean '--model'?");
  expect_complaint("replay good.csv --model model.toml --raport=x.html",
                   "replay has no option '--raport'; did you mean '--report'?");
  expect_complaint("synth --pln p.toml --out c",
                   "synth has no option '--pln'; did you mean '--plan'?");
  expect_complaint("import columns good.csv --sample-rate-hz 3 --out x",
                   "import columns has no option '--sample-rate-hz'; did you mean "
                   "'--sample-rate-Hz'?");
  expect_complaint("--vesion", "host_sim has no option '--vesion'; did you mean '--version'?");
}

TEST_F(HelpProgram, WhatIsNearNothingHasWhatIsAccepted) {
  expect_complaint("import xyzzy good.csv",
                   "'xyzzy' is no verb of import; accepted: davinci, columns");
  expect_complaint("pack model.toml --quux",
                   "pack has no option '--quux'; accepted: --help, --out, --format, --without");
  expect_complaint("help replay good", "replay has no verbs of its own");
}

// A value that looks like a verb, and a file of the name of one, are neither.
TEST_F(HelpProgram, ValuesAreNotVerbs) {
  expect_complaint("replay repaly --model=plna --input repart",
                   "--input: repart not in {input_tension,motor_current,output_tension}");
  expect_complaint("plan --levels 42.5,55 --use-tension",
                   "--use-tension: 1 required FLOAT:ABOVE 0 missing");
}

TEST_F(HelpProgram, ASummaryEndsWithTheNextStep) {
  ASSERT_EQ(run("replay good.csv --model model.toml"), 0) << err_;
  EXPECT_EQ(last_line(), "  next          --report replay.html draws this");
  ASSERT_EQ(run("replay good.csv --model model.toml --report r.html"), 0) << err_;
  EXPECT_EQ(last_line(),
            "  next          host_sim pack model.toml --out block.bin puts the model on a board");
  fs::copy(folder_ / "model.toml", folder_ / "my model.toml");
  ASSERT_EQ(run("replay good.csv --model 'my model.toml' --report r.html"), 0) << err_;
  EXPECT_EQ(
      last_line(),
      "  next          host_sim pack 'my model.toml' --out block.bin puts the model on a board");
  ASSERT_EQ(run("calibrate c --out fit.toml --bootstraps 50"), 0) << err_;
  EXPECT_EQ(last_line(),
            "  next          host_sim diagnose c finds what the law leaves out; host_sim replay "
            "PROFILE --model fit.toml");
}

TEST_F(HelpProgram, WhatAProgramReadsHasNoNextStep) {
  ASSERT_EQ(run("replay good.csv --model model.toml --json -"), 0) << err_;
  EXPECT_EQ(out_.find("  next  "), std::string::npos);
  EXPECT_NE(err_.find("  next  "), std::string::npos) << err_;
}

}  // namespace
}  // namespace host_sim_test
