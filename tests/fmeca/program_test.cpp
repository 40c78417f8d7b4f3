#include "tests/replay/program.hpp"

#include <nlohmann/json.hpp>

namespace {

using nlohmann::json;

using FmecaProgram = host_sim_test::Program;
using Names = std::vector<std::string>;

TEST_F(FmecaProgram, HasTheTableOfThePaper) {
  ASSERT_EQ(run("fmeca --json -"), 0) << err_;
  const json own = json::parse(out_);
  EXPECT_EQ(own["failures"].size(), 14U);
  EXPECT_EQ(own["failures"][0]["risk"], 20);
  EXPECT_EQ(own["failures"][1]["risk"], 20);
  EXPECT_NE(err_.find("14 failure modes, 2 severe"), std::string::npos) << err_;
  ASSERT_EQ(run("fmeca " EXAMPLES "/fmeca/soft_robot.toml --json -"), 0) << err_;
  EXPECT_EQ(json::parse(out_), own);
}

TEST_F(FmecaProgram, WritesATableAndAPage) {
  ASSERT_EQ(run("fmeca --table t.csv --report r.html --field " EXAMPLES "/fmeca/field.csv"), 0)
      << err_;
  const std::string table = host_sim_test::contents(folder_ / "t.csv");
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 15);
  EXPECT_NE(table.find("wire_fatigue,force transmission,wire breakage,cyclic loading,fracture,5,3,,"
                       "15,,severe,0.00067"),
            std::string::npos)
      << table;
  EXPECT_NE(host_sim_test::contents(folder_ / "r.html").find("</html>"), std::string::npos);
  EXPECT_NE(out_.find("* occurrence from the field"), std::string::npos) << out_;
}

TEST_F(FmecaProgram, RefusesATableAndFieldRecordsInOneLine) {
  std::string table = host_sim_test::contents(EXAMPLES "/fmeca/soft_robot.toml");
  table.replace(table.find("LifeStatus.Slack"), 16, "LifeStatus.Slak_");
  write("bad.toml", table);
  EXPECT_EQ(run("fmeca bad.toml --json f.json --table f.csv --report f.html"), 1);
  EXPECT_EQ(err_.substr(0, err_.find(';')),
            "bad.toml:64:12: seen_by holds 'LifeStatus.Slak_', which nothing is called");
  EXPECT_EQ(std::count(err_.begin(), err_.end(), '\n'), 1);
  write("field.csv", "failure,events,operating_hours\nrust,1,2\n");
  EXPECT_EQ(run("fmeca --field field.csv --json f.json --report f.html"), 1);
  EXPECT_EQ(err_.substr(0, err_.find(';')), "field.csv:2:1: failure 'rust' is not in the table");
  EXPECT_EQ(run("fmeca nowhere.toml"), 1);
  EXPECT_EQ(files(), (Names{"bad.toml", "field.csv", "good.csv", "model.toml"}));
}

}  // namespace
