#include <nlohmann/json.hpp>
#include <regex>

#include "tests/verbs/campaign_program.hpp"

namespace host_sim_test {
namespace {

/// A number of a file with the range that its comment states.
struct StatedRange {
  std::string line;
  std::size_t at = 0;      ///< of the number in the line
  std::size_t length = 0;  ///< of the number
  double low = 0;
  double high = 0;
  bool above = false;  ///< low itself is out of it
};

class InitProgram : public CampaignProgram {
 protected:
  static std::vector<StatedRange> ranges_in(const std::string& text) {
    const std::regex stated(
        R"((\w+ = \[?)([-+.e0-9]+).*# (?:[^,:]*, )?(above )?([-+.e0-9]+) \.\. ([-+.e0-9]+).*)");
    std::vector<StatedRange> all;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      std::smatch match;
      if (std::regex_match(line, match, stated)) {
        all.push_back({line, static_cast<std::size_t>(match.position(2)),
                       static_cast<std::size_t>(match.length(2)), std::stod(match[4]),
                       std::stod(match[5]), match[3].matched});
      }
    }
    return all;
  }

  /// `text` with another number in that line.
  static std::string with_number(std::string text, const StatedRange& range, double number) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.9e", number);
    const std::size_t at = text.find(range.line) + range.at;
    return text.replace(at, range.length, digits);
  }

  /// Each number is refused out of the range that is stated, for its range.
  void expect_ranges(const std::string& file, const std::string& command, std::size_t at_least) {
    const std::string text = contents(folder_ / file);
    const std::vector<StatedRange> ranges = ranges_in(text);
    EXPECT_GE(ranges.size(), at_least);
    for (const StatedRange& range : ranges) {
      SCOPED_TRACE(range.line);
      const double margin = 1e-6 * (range.high - range.low);
      for (const double outside :
           {range.above ? range.low : range.low - margin, range.high + margin}) {
        write(file, with_number(text, range, outside));
        EXPECT_EQ(run(command), 1) << outside;
        const std::string key = range.line.substr(0, range.line.find(' '));
        EXPECT_NE(err_.find("; accepted: " + key), std::string::npos) << err_;
      }
    }
    write(file, text);
  }

  /// `text` with the tables that are commented out in it.
  static std::string with_all_tables(const std::string& text) {
    std::istringstream lines(text);
    std::string all;
    bool in_table = false;
    for (std::string line; std::getline(lines, line);) {
      in_table = line.starts_with("# [") || (in_table && line.starts_with("# "));
      all += (in_table ? line.substr(2) : line) + "\n";
    }
    return std::regex_replace(all, std::regex("\n {20,}"), "\n# ");
  }
};

TEST_F(InitProgram, TheModelIsReplayedAndPacked) {
  fs::remove(folder_ / "model.toml");
  ASSERT_EQ(run("init model"), 0) << err_;
  EXPECT_NE(out_.find("host_sim replay PROFILE --model model.toml"), std::string::npos) << out_;
  EXPECT_EQ(run("replay good.csv --model model.toml"), 0) << err_;
  EXPECT_EQ(run("pack model.toml --out block.bin"), 0) << err_;
  write("model.toml", with_all_tables(contents(folder_ / "model.toml")));
  EXPECT_EQ(run("replay good.csv --model model.toml --json r.json"), 0) << err_;
  const auto result = nlohmann::json::parse(contents(folder_ / "r.json"));
  EXPECT_EQ(result["watch"]["limits"]["suggested"], false);
  expect_ranges("model.toml", "pack model.toml --out block.bin", 17);
}

TEST_F(InitProgram, TheCampaignIsCalibratedWithTheSpecimensThatItsCommentHas) {
  fs::create_directory(folder_ / "mine");
  ASSERT_EQ(run("init campaign --out mine/campaign.toml"), 0) << err_;
  EXPECT_NE(out_.find("host_sim calibrate mine"), std::string::npos) << out_;
  const std::string text = contents(folder_ / "mine/campaign.toml");
  const std::regex rows("#     (specimen,lot,.*)\n#     (w01,.*)\n");
  std::smatch match;
  ASSERT_TRUE(std::regex_search(text, match, rows));
  std::string lives = match[1].str() + "\n" + match[2].str() + "\n";
  for (const std::string row : {"w02,A,270,24.5,24.5,1200,failed", "w03,A,360,24.5,24.5,700,failed",
                                "w04,A,360,24.5,24.5,830,failed"}) {
    lives += row + "\n";
  }
  write("mine/specimens.csv", lives);
  EXPECT_EQ(run("calibrate mine --out fit.toml --bootstraps 50"), 0) << err_;
  EXPECT_NE(out_.find("lifting"), std::string::npos) << out_;
  EXPECT_EQ(run("replay good.csv --model fit.toml"), 0) << err_;
  write("mine/campaign.toml", with_all_tables(text));
  expect_ranges("mine/campaign.toml", "calibrate mine --bootstraps 1", 17);
}

TEST_F(InitProgram, ThePlanIsForeseenAndSimulated) {
  ASSERT_EQ(run("init plan"), 0) << err_;
  EXPECT_NE(out_.find("host_sim plan --for-diagnosis plan.toml"), std::string::npos) << out_;
  ASSERT_EQ(run("plan --for-diagnosis plan.toml --json -"), 0) << err_;
  ASSERT_EQ(run("synth --plan plan.toml --out made"), 0) << err_;
  EXPECT_EQ(run("calibrate made --bootstraps 50"), 0) << err_;
  ASSERT_EQ(run("diagnose made --json -"), 0) << err_;
  EXPECT_EQ(nlohmann::json::parse(out_)["effects"][0]["id"], "friction_wear");
  expect_ranges("plan.toml", "synth --plan plan.toml --out other", 35);
}

TEST_F(InitProgram, TheConfigurationIsTheOneThatTheControllerIsTestedWith) {
  ASSERT_EQ(run("init controller"), 0) << err_;
  EXPECT_NE(out_.find("tendonlife_controller --config controller.toml --check"), std::string::npos)
      << out_;
  EXPECT_EQ(contents(folder_ / "controller.toml"), contents(CONTROLLER_TOML));
}

TEST_F(InitProgram, WhatIsThereIsLeftAlone) {
  const std::string before = contents(folder_ / "model.toml");
  EXPECT_EQ(run("init model"), 1);
  EXPECT_EQ(err_,
            "model.toml: cannot be written: it is there already; accepted: another name after "
            "--out\n");
  EXPECT_EQ(contents(folder_ / "model.toml"), before);
  ASSERT_EQ(run("init model --out -"), 0) << err_;
  EXPECT_EQ(out_, contents(fs::path(EXAMPLES) / "start/model.toml"));
}

}  // namespace
}  // namespace host_sim_test
