#include "tests/replay/program.hpp"

#include <nlohmann/json.hpp>

namespace host_sim_test {
namespace {

class SynthProgram : public Program {
 protected:
  void SetUp() override {
    Program::SetUp();
    std::string plan = contents(fs::path(EXAMPLES) / "synth/crossed.toml");
    plan = with(with(plan, "duration_s", "0.5"), "sessions", "4");
    write("plan.toml", plan);
  }
};

TEST_F(SynthProgram, MakesACampaignAndSealsItsTruth) {
  ASSERT_EQ(run("synth --plan plan.toml --out c --truth truth.json --json result.json --seed 5"), 0)
      << err_;
  EXPECT_TRUE(fs::exists(folder_ / "c/recordings/s004.csv"));
  const auto result = nlohmann::json::parse(contents(folder_ / "result.json"));
  EXPECT_EQ(result["sessions"], 4);
  EXPECT_EQ(result["seed"], 5);
  const std::string digest = result["truth_sha256"];
  EXPECT_NE(out_.find("SHA-256 of the truth: " + digest), std::string::npos) << out_;
  // Checked with the tool that everybody has.
  const std::string check = "cd '" + folder_.string() + "' && echo '" + digest +
                            "  truth.json' | sha256sum --check --status";
  EXPECT_EQ(std::system(check.c_str()), 0);
  const auto truth = nlohmann::json::parse(contents(folder_ / "truth.json"));
  EXPECT_EQ(truth["effects"][0]["id"], "friction_wear");
}

TEST_F(SynthProgram, RefusesWhatStandsThere) {
  ASSERT_EQ(run("synth --plan plan.toml --out c"), 0) << err_;
  const std::string before = contents(folder_ / "c/recordings/s001.csv");
  EXPECT_EQ(run("synth --plan plan.toml --out c --seed 2"), 1);
  EXPECT_NE(err_.find("--force"), std::string::npos) << err_;
  EXPECT_EQ(contents(folder_ / "c/recordings/s001.csv"), before);
  EXPECT_EQ(run("synth --plan plan.toml --out c --seed 2 --force"), 0) << err_;
  EXPECT_NE(contents(folder_ / "c/recordings/s001.csv"), before);
}

TEST_F(SynthProgram, TheTruthMayNotLieInTheFolder) {
  EXPECT_EQ(run("synth --plan plan.toml --out c --truth c/truth.json"), 2);
  EXPECT_NE(err_.find("--truth 'c/truth.json' would lie in the folder of --out"), std::string::npos)
      << err_;
  EXPECT_FALSE(fs::exists(folder_ / "c"));
}

TEST_F(SynthProgram, ABadPlanLeavesNothing) {
  write("bad.toml", contents(folder_ / "plan.toml") + "\n[effects.rust]\n");
  const auto before = files();
  EXPECT_EQ(run("synth --plan bad.toml --out c --truth t.json"), 1);
  EXPECT_EQ(err_.rfind("bad.toml:", 0), 0U) << err_;
  EXPECT_NE(err_.find("unknown table 'rust' in [effects]"), std::string::npos) << err_;
  EXPECT_EQ(files(), before);
}

TEST_F(SynthProgram, TheExamplesAreOfTheSizeTheySay) {
  const std::string examples = std::string(EXAMPLES) + "/synth/";
  ASSERT_EQ(run("synth --plan '" + examples + "crossed.toml' --out c --json -"), 0) << err_;
  EXPECT_EQ(nlohmann::json::parse(out_)["sessions"], 36);
  ASSERT_EQ(run("synth --plan '" + examples + "lives.toml' --out l --json -"), 0) << err_;
  EXPECT_EQ(nlohmann::json::parse(out_)["specimens"], 96);
}

TEST_F(SynthProgram, TheRecordedExampleIsWhatItsPlanMakes) {
  const fs::path examples(EXAMPLES);
  ASSERT_EQ(run("synth --plan '" + (examples / "synth/recorded.toml").string() +
                "' --out recorded --seed 1"),
            0)
      << err_;
  std::size_t bytes = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder_ / "recorded")) {
    if (entry.is_regular_file()) {
      const std::string made = contents(entry.path());
      EXPECT_EQ(made, contents(examples / fs::relative(entry.path(), folder_))) << entry.path();
      bytes += made.size();
    }
  }
  EXPECT_GT(bytes, 150'000U);
  EXPECT_LT(bytes, 300'000U);
}

// Of the recordings too, where there are lives: a campaign that holds both is one that is read.
TEST_F(SynthProgram, RecordingsAreOfASpecimenWhereThereAreSome) {
  write("both.toml", contents(folder_ / "plan.toml") +
                         "\n[lives]\n[[lives.level]]\nbend_angle_deg = 270\n"
                         "output_tension_mean_N = 24.5\noutput_tension_amplitude_N = 24.5\n"
                         "specimens = 4\n");
  ASSERT_EQ(run("synth --plan both.toml --out c"), 0) << err_;
  EXPECT_EQ(run("diagnose c --json -"), 0) << err_;
  const auto diagnosis = nlohmann::json::parse(out_);
  EXPECT_FALSE(diagnosis["tension"].is_null());
  EXPECT_FALSE(diagnosis["lives"].is_null());
}

}  // namespace
}  // namespace host_sim_test
