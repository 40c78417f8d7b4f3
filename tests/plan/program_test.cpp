#include "tests/replay/program.hpp"

#include <nlohmann/json.hpp>

namespace {

using nlohmann::json;

using PlanProgram = host_sim_test::Program;

const std::string kLaw = "plan --scale 1.53e5 --exponent 1.38 --shape 5.94 --simulations 100 ";
const std::string kLevels = "--levels 42.5,55,70.8 --use-tension 38 ";

TEST_F(PlanProgram, FindsAPlan) {
  ASSERT_EQ(run(kLaw + kLevels + "--ratio 1.5 --json plan.json"), 0) << err_;
  const json written = json::parse(host_sim_test::contents(folder_ / "plan.json"));
  EXPECT_EQ(written["reached"], true);
  EXPECT_NE(out_.find("fewest specimens: "), std::string::npos) << out_;
  EXPECT_EQ(err_, "");
}

TEST_F(PlanProgram, DrawsAPlan) {
  ASSERT_EQ(run(kLaw + kLevels + "--specimens 4,4,4 --report plan.html"), 0) << err_;
  const std::string page = host_sim_test::contents(folder_ / "plan.html");
  EXPECT_NE(page.find("<title>Tendon life: plan of a life test</title>"), std::string::npos);
  EXPECT_EQ(run("plan --for-diagnosis plan.toml --report plan.html"), 2);
  EXPECT_NE(err_.find("--report"), std::string::npos) << err_;
}

TEST_F(PlanProgram, TakesTheLawOfAModel) {
  ASSERT_EQ(run("plan --model model.toml --simulations 100 --specimens 4,4,4 --json - " + kLevels),
            0)
      << err_;
  const json written = json::parse(out_);
  EXPECT_EQ(written["law"]["ipl_scale"], 1.53e5);
  EXPECT_EQ(written["law"]["ipl_exponent"], 1.38);
  EXPECT_EQ(written["law"]["weibull_shape"], 5.94);
  EXPECT_NE(err_.find("B10 at 38 N"), std::string::npos) << err_;
}

TEST_F(PlanProgram, SortsLevelsWithTheirSpecimens) {
  ASSERT_EQ(run(kLaw + "--levels 70.8,42.5 --specimens 3,9 --use-tension 38 --json -"), 0) << err_;
  const json levels = json::parse(out_)["plans"][0]["levels"];
  EXPECT_EQ(levels[0]["effective_tension_N"], 42.5);
  EXPECT_EQ(levels[0]["specimens"], 9);
  EXPECT_EQ(levels[1]["specimens"], 3);
}

TEST_F(PlanProgram, TellsWhatACampaignOfRecordingsCouldShow) {
  const std::string plan = EXAMPLES "/synth/crossed.toml";
  ASSERT_EQ(run("plan --json foresight.json --for-diagnosis " + plan), 0) << err_;
  const json written = json::parse(host_sim_test::contents(folder_ / "foresight.json"));
  EXPECT_EQ(written["sessions"], 36);
  // A stiff spring is taken up in so short a travel that its end looks like that of presliding.
  EXPECT_EQ(written["equivalent_sets"],
            json::parse(R"([["channel_delay", "filter_lag"], ["compliance", "presliding"]])"));
  EXPECT_NE(out_.find("friction_wear"), std::string::npos) << out_;
  EXPECT_EQ(err_, "");
}

TEST_F(PlanProgram, NamesAPlanOfRecordingsThatIsNotThere) {
  EXPECT_EQ(run("plan --for-diagnosis nowhere.toml"), 1);
  EXPECT_NE(err_.find("nowhere.toml"), std::string::npos) << err_;
}

TEST_F(PlanProgram, EndsWellWhereTheGoalIsOutOfReach) {
  ASSERT_EQ(run(kLaw + kLevels + "--ratio 1.001 --specimens-max 10 --json -"), 0) << err_;
  EXPECT_EQ(json::parse(out_)["reached"], false);
  EXPECT_NE(err_.find("not reached with 10 specimens"), std::string::npos) << err_;
}

TEST_F(PlanProgram, TellsOptionsThatDoNotFit) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {kLaw + kLevels, "give --ratio to search for a plan, or --specimens to try one"},
      {kLaw + kLevels + "--ratio 1", "--ratio"},
      {kLaw + kLevels + "--ratio nan", "--ratio"},
      {kLaw + kLevels + "--ratio inf", "--ratio"},
      {kLaw + "--levels 40 --use-tension 38 --ratio 2", "at least two levels"},
      {kLaw + "--levels 40,50,40 --use-tension 38 --ratio 2", "40 N is there twice"},
      {kLaw + "--levels 40,-5 --use-tension 38 --ratio 2", "--levels"},
      {kLaw + "--levels 40,50 --use-tension 0 --ratio 2", "--use-tension"},
      {kLaw + kLevels + "--specimens 3,3", "2 numbers for 3 levels"},
      {kLaw + kLevels + "--specimens 0,3,0", "at least two levels need specimens"},
      {kLaw + kLevels + "--specimens 3,3,-1", "--specimens"},
      {kLaw + kLevels + "--ratio 2 --specimens-max 5", "3 levels need at least 6 specimens"},
      {kLaw + "--use-tension 38 --ratio 2", "--levels is required"},
      {kLaw + "--levels 40,50 --ratio 2", "--use-tension is required"},
      {"plan --for-diagnosis plan.toml --levels 40,50", "--for-diagnosis excludes --levels"},
      {kLaw + kLevels + "--ratio 2 --assurance 1", "--assurance"},
      {kLaw + kLevels + "--ratio 2 --suspend-at 0", "--suspend-at"},
      {"plan --scale 1e5 --exponent 2 --ratio 2 " + kLevels, "--shape"},
      {"plan --ratio 2 " + kLevels, "give the law: --model"},
      {"plan --model model.toml --shape 3 --ratio 2 " + kLevels, "--model"},
      {"plan --model model.toml --levels 40,180 --use-tension 38 --ratio 2",
       "180 N is not below the ultimate tension of the model, 177.4 N"},
  };
  for (const auto& [arguments, message] : cases) {
    EXPECT_EQ(run(arguments + " --json plan.json"), 2) << arguments;
    EXPECT_NE(err_.find(message), std::string::npos) << arguments << '\n' << err_;
    EXPECT_EQ(out_, "") << arguments;
    EXPECT_EQ(files(), (std::vector<std::string>{"good.csv", "model.toml"})) << arguments;
  }
}

TEST_F(PlanProgram, TellsAModelThatCannotBeRead) {
  EXPECT_EQ(run("plan --model none.toml --ratio 2 " + kLevels), 1);
  EXPECT_NE(err_.find("none.toml"), std::string::npos) << err_;
}

TEST_F(PlanProgram, HelpsWithAnExample) {
  EXPECT_EQ(run("plan --help"), 0);
  EXPECT_NE(out_.find("Example: host_sim plan --model"), std::string::npos);
}

}  // namespace
