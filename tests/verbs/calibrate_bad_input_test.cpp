#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/verbs/campaign_program.hpp"

namespace {

using host_sim_test::CampaignProgram;
using host_sim_test::contents;
using nlohmann::json;
namespace fs = std::filesystem;

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
