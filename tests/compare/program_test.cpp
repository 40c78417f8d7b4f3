#include "tests/replay/program.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace {

using nlohmann::json;

using CompareProgram = host_sim_test::Program;
using Names = std::vector<std::string>;

TEST_F(CompareProgram, WritesItsResultAndAPage) {
  write("half.toml", host_sim_test::with(host_sim_test::contents(folder_ / "model.toml"),
                                         "ipl_scale", "7.65e4"));
  ASSERT_EQ(run("compare model.toml half.toml --profile good.csv --json c.json --report c.html"), 0)
      << err_;
  EXPECT_NE(out_.find("The wire lives 0.5 times as long with model B as with A"), std::string::npos)
      << out_;
  const json result = json::parse(host_sim_test::contents(folder_ / "c.json"));
  EXPECT_EQ(result["of"], "models");
  EXPECT_EQ(result["differences"][0]["name"], "life.ipl_scale");
  EXPECT_NEAR(result["b_over_a"]["damage"].get<double>(), 2, 1e-5);
  EXPECT_EQ(result["first_sample"], nullptr);
  EXPECT_NE(host_sim_test::contents(folder_ / "c.html").find("</html>"), std::string::npos);
}

TEST_F(CompareProgram, ComparesAProfileInAnotherUnit) {
  write("current.csv", "time_s,motor_current_A\n0,1\n0.005,2\n0.01,1\n");
  ASSERT_EQ(run("compare good.csv current.csv --model model.toml --json -"), 0) << err_;
  EXPECT_EQ(json::parse(out_)["first_sample"]["b"], (json{{"line", 2}, {"value", 1.0}}));
  EXPECT_NE(err_.find("A line 2 with 10 N, B line 2 with 1 A."), std::string::npos) << err_;
}

TEST_F(CompareProgram, RefusesInOneLineWhatCannotBeCompared) {
  const auto refused = [this](const std::string& arguments, const std::string& words) {
    EXPECT_EQ(run("compare " + arguments + " --json c.json --report c.html"), 2) << arguments;
    EXPECT_NE(err_.find(words), std::string::npos) << arguments << '\n' << err_;
  };
  refused("model.toml good.csv --profile good.csv",
          "model.toml is a model and good.csv is a profile; accepted: two models (*.toml) with "
          "--profile, or two profiles with --model");
  refused("model.toml model.toml", "--profile is required");
  refused("good.csv good.csv", "--model is required");
  refused("good.csv good.csv --profile good.csv", "--profile is for two models");
  refused("model.toml model.toml --model model.toml", "--model is for two profiles");
  refused("good.csv - --model model.toml", "standard input is no profile to compare");
  write("bad.csv", "time_s,input_tension_N\n0,ten\n");
  EXPECT_EQ(run("compare good.csv bad.csv --model model.toml --json c.json"), 1);
  EXPECT_EQ(err_.find("bad.csv:2:3:"), 0U) << err_;
  EXPECT_EQ(std::count(err_.begin(), err_.end(), '\n'), 1);
  EXPECT_EQ(files(), (Names{"bad.csv", "good.csv", "model.toml"}));
}

}  // namespace
