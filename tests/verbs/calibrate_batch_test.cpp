#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/verbs/campaign_program.hpp"

namespace {

using host_sim_test::CampaignProgram;
using host_sim_test::contents;
using nlohmann::json;
namespace fs = std::filesystem;

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

}  // namespace
