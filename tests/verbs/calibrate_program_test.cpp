#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <utility>
#include <vector>

#include "tests/replay/interrupted.hpp"
#include "tests/verbs/campaign_program.hpp"

namespace {

namespace fs = std::filesystem;
using host_sim_test::CampaignProgram;
using host_sim_test::contents;
using nlohmann::json;

TEST_F(CampaignProgram, CalibratesThePapersExample) {
  ASSERT_EQ(run("calibrate '" EXAMPLES "/tendon_alt' --bootstraps 200 --out fitted.toml --json "
                "result.json --report page.html"),
            0)
      << err_;
  const json all = json::parse(contents(folder_ / "result.json"));
  // The paper's Table 4: seven levels with those of the application, common shape 5.94.
  EXPECT_EQ(all["levels"].size(), 7U);
  EXPECT_NEAR(all["common_shape"]["value"].get<double>(), 5.94, 0.005);
  EXPECT_NE(out_.find("540 deg, 99.4 N (left out)"), std::string::npos) << out_;
  EXPECT_NE(out_.find("common shape"), std::string::npos);
  EXPECT_NE(contents(folder_ / "page.html").find("</html>"), std::string::npos);
  EXPECT_TRUE(err_.empty()) << err_;
}

TEST_F(CampaignProgram, WritesAModelThatReplayAndPackRead) {
  ASSERT_EQ(run("calibrate c --bootstraps 20 --out fitted.toml --json r.json"), 0) << err_;
  const json law = json::parse(contents(folder_ / "r.json"))["ipl"];
  EXPECT_EQ(run("pack fitted.toml --out block.bin"), 0) << err_;
  ASSERT_EQ(run("replay good.csv --model fitted.toml --json used.json"), 0) << err_;
  // One and a half cycles of 10 to 60 N: mean 35 N, amplitude 25 N, T_u 177.4 N; eqs. (11), (19).
  const double effective_N = 25 / (1 - std::pow(35 / 177.4, 2));
  const double damage =
      1.5 * std::pow(effective_N, law["exponent"].get<double>()) / law["scale"].get<double>();
  const json used = json::parse(contents(folder_ / "used.json"));
  EXPECT_NEAR(used["damage"]["total"].get<double>() / damage, 1, 1e-5);
}

TEST_F(CampaignProgram, ResultsAreTheSameForAnyNumberOfThreads) {
  ASSERT_EQ(run("calibrate c --bootstraps 100 --threads 1 --json 1.json --report 1.html"), 0);
  ASSERT_EQ(run("calibrate c --bootstraps 100 --threads 3 --json 3.json --report 3.html"), 0);
  EXPECT_EQ(contents(folder_ / "1.json"), contents(folder_ / "3.json"));
  EXPECT_EQ(contents(folder_ / "1.html"), contents(folder_ / "3.html"));
  ASSERT_EQ(run("calibrate c --bootstraps 100 --seed 2 --json other.json"), 0);
  EXPECT_NE(contents(folder_ / "1.json"), contents(folder_ / "other.json"));
}

TEST_F(CampaignProgram, JsonOnStandardOutputSendsTheSummaryElsewhere) {
  ASSERT_EQ(run("calibrate c --bootstraps 20 --json -"), 0) << err_;
  EXPECT_EQ(json::parse(out_)["campaign"], "small");
  EXPECT_EQ(err_.rfind("small: 15 specimens", 0), 0U) << err_;
}

TEST_F(CampaignProgram, UseTensionsAreAnswered) {
  ASSERT_EQ(run("calibrate c --bootstraps 20 --use-tension 45,25.5 --json -"), 0) << err_;
  const json uses = json::parse(out_)["use_levels"];
  ASSERT_EQ(uses.size(), 2U);
  EXPECT_EQ(uses[0]["effective_tension_N"], 45);
  EXPECT_EQ(uses[1]["effective_tension_N"], 25.5);
  EXPECT_LT(uses[0]["ci95_B10"][0].get<double>(), uses[0]["B10"].get<double>());
}

TEST_F(CampaignProgram, FailsOnWhatItIsAskedToFailOn) {
  const std::string example = "calibrate '" EXAMPLES "/tendon_alt' --bootstraps 200 --json r.json ";
  EXPECT_EQ(run(example + "--fail-on left-out"), 3);
  EXPECT_TRUE(fs::exists(folder_ / "r.json"));
  EXPECT_EQ(run(example + "--fail-on any"), 3);
  EXPECT_EQ(run(example + "--fail-on shape,fit"), 0);
  EXPECT_EQ(run(example + "--fail-on shape --keep-all-levels"), 3);
  EXPECT_EQ(run("calibrate c --bootstraps 20 --fail-on left-out,validation"), 0);
}

TEST_F(CampaignProgram, WrongUsageIsStatusTwo) {
  for (const char* arguments :
       {"calibrate", "calibrate c --fail-on nothing", "calibrate c --bootstraps 0",
        "calibrate c --threads 0", "calibrate c --use-tension 0", "calibrate c --use-tension -1",
        "calibrate c --use-tension nan", "calibrate c --use-tension inf", "calibrate c --seed x",
        "calibrate c --batch", "calibrate c --table t.csv",
        "calibrate c --batch --table t.csv --out m.toml",
        "calibrate c --batch --table t.csv --report p.html", "calibrate c --json same --out same",
        "calibrate c --json same --report ./same", "calibrate c --json - --out -"}) {
    const auto before = files();
    EXPECT_EQ(run(arguments), 2) << arguments;
    EXPECT_FALSE(err_.empty());
    EXPECT_EQ(files(), before) << arguments;
  }
}

TEST_F(CampaignProgram, HelpHasAnExample) {
  EXPECT_EQ(run("calibrate --help"), 0);
  EXPECT_NE(out_.find("Example: host_sim calibrate host_sim/examples/tendon_alt"),
            std::string::npos);
}

class Batch : public CampaignProgram {
 protected:
  void SetUp() override {
    CampaignProgram::SetUp();
    for (const char* name : {"all/b", "all/a", "all/c"}) {
      write_campaign(name, specimens());
    }
    fs::create_directories(folder_ / "all/no campaign");
  }

  [[nodiscard]] std::vector<std::string> rows(const std::string& table) const {
    std::istringstream text(contents(folder_ / table));
    std::vector<std::string> lines;
    for (std::string line; std::getline(text, line);) {
      lines.push_back(line);
    }
    return lines;
  }

  static std::string first_field(const std::string& row) { return row.substr(0, row.find(',')); }
};

TEST_F(Batch, OneRowForEachCampaignInOrderOfName) {
  ASSERT_EQ(run("calibrate all --batch --bootstraps 20 --table t.csv --json all.json"), 0) << err_;
  const auto table = rows("t.csv");
  ASSERT_EQ(table.size(), 4U);
  EXPECT_EQ(first_field(table[0]), "campaign");
  EXPECT_EQ(first_field(table[1]), "a");
  EXPECT_EQ(first_field(table[2]), "b");
  EXPECT_EQ(first_field(table[3]), "c");
  // Equal campaigns have equal rows behind their names.
  EXPECT_EQ(table[1].substr(1), table[2].substr(1));
  EXPECT_NE(out_.find("3 campaigns calibrated, 0 refused"), std::string::npos) << out_;
  const json all = json::parse(contents(folder_ / "all.json"));
  ASSERT_EQ(all["campaigns"].size(), 3U);
  EXPECT_EQ(all["campaigns"][1]["folder"], "b");
  ASSERT_EQ(run("calibrate all/b --bootstraps 20 --json -"), 0) << err_;
  EXPECT_EQ(all["campaigns"][1]["result"], json::parse(out_));
}

TEST_F(Batch, IsTheSameForAnyNumberOfThreads) {
  const std::string batch = "calibrate all --batch --bootstraps 50 ";
  ASSERT_EQ(run(batch + "--table 1.csv --json 1.json --threads 1"), 0) << err_;
  ASSERT_EQ(run(batch + "--table 7.csv --json 7.json --threads 7"), 0) << err_;
  EXPECT_EQ(contents(folder_ / "1.csv"), contents(folder_ / "7.csv"));
  EXPECT_EQ(contents(folder_ / "1.json"), contents(folder_ / "7.json"));
}

TEST_F(Batch, ABadCampaignDoesNotStopTheOthers) {
  write("all/b/specimens.csv", "specimen\n");
  EXPECT_EQ(run("calibrate all --batch --bootstraps 20 --table t.csv --json all.json"), 1);
  EXPECT_EQ(std::count(err_.begin(), err_.end(), '\n'), 1) << err_;
  EXPECT_EQ(err_.rfind("all/b/specimens.csv:1", 0), 0U) << err_;
  const auto table = rows("t.csv");
  ASSERT_EQ(table.size(), 4U);
  EXPECT_EQ(table[2].rfind("b,,,", 0), 0U) << table[2];
  EXPECT_NE(table[2].find("all/b/specimens.csv:1"), std::string::npos) << table[2];
  EXPECT_EQ(table[1].substr(1), table[3].substr(1));
  EXPECT_NE(out_.find("2 campaigns calibrated, 1 refused"), std::string::npos) << out_;
  const json all = json::parse(contents(folder_ / "all.json"));
  EXPECT_TRUE(all["campaigns"][1].contains("error"));
  EXPECT_FALSE(all["campaigns"][1].contains("result"));
}

TEST_F(Batch, FailsOnWhatOneCampaignHas) {
  write_campaign("all/b", level("a", 40, 800));
  EXPECT_EQ(run("calibrate all --batch --bootstraps 20 --table t.csv --fail-on fit"), 3) << err_;
  EXPECT_EQ(run("calibrate all --batch --bootstraps 20 --table t.csv --fail-on left-out"), 0);
}

TEST_F(Batch, AFolderWithoutCampaignsIsRefused) {
  fs::create_directories(folder_ / "none");
  for (const std::string folder : {"none", "nowhere", "model.toml"}) {
    const auto before = files();
    EXPECT_EQ(run("calibrate " + folder + " --batch --table t.csv"), 1);
    EXPECT_EQ(err_.rfind(folder, 0), 0U) << err_;
    EXPECT_EQ(std::count(err_.begin(), err_.end(), '\n'), 1) << err_;
    EXPECT_EQ(files(), before);
  }
}

TEST_F(Batch, TheTableMayGoToStandardOutput) {
  ASSERT_EQ(run("calibrate all --batch --bootstraps 20 --table -"), 0) << err_;
  EXPECT_EQ(std::count(out_.begin(), out_.end(), '\n'), 4);
  EXPECT_NE(err_.find("3 campaigns calibrated"), std::string::npos) << err_;
}

class InterruptedCalibration : public CampaignProgram {
 protected:
  [[nodiscard]] int interrupted(std::vector<const char*> arguments) const {
    return host_sim_test::status_of_interrupted(folder_, std::move(arguments));
  }
};

TEST_F(InterruptedCalibration, LeavesNothingBehind) {
  const auto before = files();
  EXPECT_EQ(interrupted({"calibrate", "c", "--bootstraps", "20000", "--json", "r.json"}), 130);
  EXPECT_EQ(contents(folder_ / "err.txt"), "host_sim: interrupted; no output was written\n");
  fs::remove(folder_ / "err.txt");
  EXPECT_EQ(files(), before);
}

TEST_F(InterruptedCalibration, OfABatchLeavesNothingBehind) {
  for (int i = 0; i < 100; ++i) {
    write_campaign("all/" + std::to_string(i), specimens());
  }
  const auto before = files();
  EXPECT_EQ(
      interrupted({"calibrate", "all", "--batch", "--bootstraps", "2000", "--table", "t.csv"}),
      130);
  EXPECT_EQ(contents(folder_ / "err.txt"), "host_sim: interrupted; no output was written\n");
  fs::remove(folder_ / "err.txt");
  EXPECT_EQ(files(), before);
}

/// With these the program is to say nothing but one line, and to leave nothing behind.
class BadCampaign : public CampaignProgram {
 protected:
  void expect_refusal(const std::string& place, const std::string& words) {
    const auto before = files();
    EXPECT_EQ(run("calibrate c --bootstraps 20 --out m.toml --json r.json --report p.html"), 1);
    EXPECT_EQ(std::count(err_.begin(), err_.end(), '\n'), 1) << err_;
    EXPECT_EQ(err_.rfind(place, 0), 0U) << err_;
    EXPECT_NE(err_.find(words), std::string::npos) << err_;
    EXPECT_NE(err_.find("; accepted: "), std::string::npos) << err_;
    EXPECT_TRUE(out_.empty()) << out_;
    EXPECT_EQ(files(), before);
  }

  /// The campaign with one more row, in line 17.
  void with_row(const std::string& row) { write_campaign("c", specimens() + row); }

  json result_of(const std::string& rows) {
    write_campaign("c", rows);
    EXPECT_EQ(run("calibrate c --bootstraps 20 --json -"), 0) << err_;
    return out_.empty() ? json() : json::parse(out_);
  }

  static bool warned(const json& result, const std::string& words) {
    const json& warnings = result["warnings"];
    return std::any_of(warnings.begin(), warnings.end(), [&](const json& warning) {
      return warning.get<std::string>().find(words) != std::string::npos;
    });
  }
};

TEST_F(BadCampaign, CyclesThatAreNone) {
  for (const char* cycles : {"0", "-5", "nan", "inf", "", "1e400", "many"}) {
    with_row(row("d1", 40, cycles, "failed"));
    expect_refusal("c/specimens.csv:17:", "cycles");
  }
}

TEST_F(BadCampaign, ADuplicateSpecimen) {
  with_row(row("a1", 40, "700", "failed"));
  expect_refusal("c/specimens.csv:17:", "a1");
}

TEST_F(BadCampaign, AnUnknownStatus) {
  with_row(row("d1", 40, "700", "broken"));
  expect_refusal("c/specimens.csv:17:", "broken");
}

TEST_F(BadCampaign, BlocksThatAreNotThoseOfTheSpecimens) {
  write("c/blocks.csv",
        "specimen,order,input_tension_mean_N,input_tension_amplitude_N,cycles\n"
        "a1,1,0,45,100\na1,2,0,55,100\n");
  expect_refusal("c/", "a1");
}

TEST_F(BadCampaign, BlocksOfNobody) {
  write("c/blocks.csv",
        "specimen,order,input_tension_mean_N,input_tension_amplitude_N,cycles\nx9,1,0,45,100\n");
  expect_refusal("c/blocks.csv:2:", "x9");
}

TEST_F(BadCampaign, NoFailuresAtAll) {
  write_campaign("c", row("a1", 40, "700", "suspended") + row("b1", 50, "700", "suspended"));
  expect_refusal("c/specimens.csv", "0 failed of 2");
}

TEST_F(BadCampaign, OneFailureOnly) {
  write_campaign("c", row("a1", 40, "700", "failed") + row("b1", 50, "700", "suspended"));
  expect_refusal("c/specimens.csv", "1 failed of 2");
}

TEST_F(BadCampaign, NoFolderAndNoFiles) {
  fs::remove(folder_ / "c/specimens.csv");
  expect_refusal("c/specimens.csv", "");
  fs::remove(folder_ / "c/campaign.toml");
  expect_refusal("c", "");
  fs::remove_all(folder_ / "c");
  expect_refusal("c", "");
}

TEST_F(BadCampaign, RecordingsOnly) {
  fs::remove(folder_ / "c/specimens.csv");
  write("c/sessions.csv", "session,specimen,file,start_cycle\ns1,a1,s1.csv,0\n");
  expect_refusal("c: recordings only", "specimens.csv");
}

TEST_F(BadCampaign, ANominalModelThatReplayCannotUse) {
  write("c/campaign.toml",
        "[campaign]\nname = \"small\"\n\n[model.cable]\ndiameter_mm = 0.457\n"
        "ultimate_tension_N = 177.4\n");
  expect_refusal("c/campaign.toml", "[model.sheath]");
  EXPECT_EQ(run("calibrate c --bootstraps 20"), 0) << err_;
}

TEST_F(BadCampaign, ALawThatNoModelCanHold) {
  // Life grows with tension: an exponent below 1.
  write_campaign("c", level("a", 40, 400) + level("b", 50, 600) + level("c", 60, 800));
  expect_refusal("c/campaign.toml", "ipl_exponent");
}

TEST_F(BadCampaign, FewerThanTwoFailuresInALevelIsAWarningWithItsLine) {
  const json result =
      result_of(specimens() + row("d1", 70, "330", "failed") + row("d2", 70, "400", "suspended"));
  EXPECT_TRUE(warned(result, "c/specimens.csv:17:")) << result["warnings"];
  EXPECT_TRUE(warned(result, "1 failed of 2")) << result["warnings"];
  EXPECT_EQ(result["levels"][3]["scale"], nullptr);
  EXPECT_NE(result["ipl"], nullptr);
}

TEST_F(BadCampaign, ALevelAllSuspendedIsAWarning) {
  const json result = result_of(specimens() + row("d1", 30, "2000", "suspended") +
                                row("d2", 30, "2000", "suspended"));
  EXPECT_TRUE(warned(result, "0 failed of 2")) << result["warnings"];
  EXPECT_EQ(result["levels"][0]["shape"], nullptr);
}

TEST_F(BadCampaign, AFitOnTheBoundaryIsAWarning) {
  const json result =
      result_of(specimens() + row("d1", 70, "330", "failed") + row("d2", 70, "330", "failed"));
  EXPECT_TRUE(warned(result, "c/specimens.csv:17:")) << result["warnings"];
  EXPECT_TRUE(warned(result, "boundary")) << result["warnings"];
  EXPECT_EQ(result["levels"][3]["shape"], nullptr);
}

TEST_F(BadCampaign, OneLevelHasNoLawAndSaysSo) {
  const json result = result_of(level("a", 40, 800));
  EXPECT_EQ(result["ipl"], nullptr);
  EXPECT_TRUE(warned(result, "there is no life law")) << result["warnings"];
  EXPECT_EQ(run("calibrate c --bootstraps 20 --fail-on fit"), 3);
  const auto before = files();
  EXPECT_EQ(run("calibrate c --bootstraps 20 --out m.toml"), 1);
  EXPECT_EQ(std::count(err_.begin(), err_.end(), '\n'), 1) << err_;
  EXPECT_NE(err_.find("no life law"), std::string::npos) << err_;
  EXPECT_EQ(files(), before);
}

TEST_F(BadCampaign, AnOutputThatCannotBeWrittenIsFoundBeforeTheWork) {
  EXPECT_EQ(run("calibrate c --bootstraps 10000000 --json no/such/folder/r.json"), 1);
  EXPECT_EQ(err_.rfind("no/such/folder/r.json", 0), 0U) << err_;
}

TEST_F(BadCampaign, AnErrorKeepsAnEarlierResult) {
  ASSERT_EQ(run("calibrate c --bootstraps 20 --json r.json"), 0) << err_;
  const std::string before = contents(folder_ / "r.json");
  with_row(row("a1", 40, "700", "failed"));
  EXPECT_EQ(run("calibrate c --bootstraps 20 --json r.json"), 1);
  EXPECT_EQ(contents(folder_ / "r.json"), before);
}

}  // namespace
