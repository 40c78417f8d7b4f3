#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/replay/table_program.hpp"

namespace {

using host_sim_test::contents;
using host_sim_test::TableProgram;
using Names = std::vector<std::string>;
namespace fs = std::filesystem;

/// Life that one and a half cycles between 10 N and `high_N` use, by (11), (19) and Miner's rule
/// with the paper's constants and another A.
double life_used(double high_N, double ipl_scale = 1.53e5) {
  const double mean_N = (high_N + 10) / 2;
  const double effective_N = (high_N - 10) / 2 / (1 - std::pow(mean_N / 177.4, 2));
  return 1.5 * std::pow(effective_N, 1.38) / ipl_scale;
}

TEST_F(TableProgram, HasOneRowForEachProfileInNaturalOrder) {
  ASSERT_EQ(run("replay logs/ --model model.toml --table t.csv"), 0) << err_;
  const auto table = rows("t.csv");
  EXPECT_EQ(column(table, "profile"), (Names{"r2/day9.csv", "r2/day10.csv", "r10/day1.csv"}));
  EXPECT_EQ(column(table, "model"), Names(3, "model.toml"));
  EXPECT_EQ(column(table, "peak_tension_N"), (Names{"60", "50", "40"}));
  EXPECT_EQ(column(table, "samples"), Names(3, "4"));
  EXPECT_EQ(column(table, "error"), Names(3, ""));
  EXPECT_NEAR(std::stod(table[0].at("damage_total")) / life_used(60), 1, 1e-4);
  EXPECT_NEAR(std::stod(table[2].at("damage_total")) / life_used(40), 1, 1e-4);
  EXPECT_NEAR(std::stod(table[2].at("reference_damage_total")) / life_used(40), 1, 1e-12);
  EXPECT_NE(out_.find("3 profiles replayed, 0 refused"), std::string::npos) << out_;
  EXPECT_NE(out_.find(" in r2/day9.csv"), std::string::npos) << "most life: " << out_;
}

/// Each number and name of the result of one profile in the column of its name.
void expect_same(const std::map<std::string, std::string>& row, const nlohmann::json& result) {
  std::size_t compared = 0;
  const nlohmann::json flat = result.flatten();
  for (const auto& [pointer, value] : flat.items()) {
    std::string name = pointer.substr(1);
    std::replace(name.begin(), name.end(), '/', '_');
    if (name.starts_with("flags") || name.starts_with("warnings")) {
      continue;
    }
    ++compared;
    const std::string& text = row.at(name);
    if (value.is_null()) {
      EXPECT_EQ(text, "inf") << name;
    } else if (value.is_string()) {
      EXPECT_EQ(text, value.get<std::string>()) << name;
    } else {
      EXPECT_EQ(std::stod(text), value.get<double>()) << name;
    }
  }
  EXPECT_EQ(compared, 22U);
}

TEST_F(TableProgram, SaysWhatEachProfileSaysAlone) {
  write("logs/r2/day9.csv", contents(fs::path(EXAMPLES) / "upper_arm.csv"));
  write("logs/r10/day1.csv", "time_s,input_tension_N\n0,10\n0.005,190\n0.04,-1\n");
  write("logs/r10/idle.csv", "time_s,input_tension_N\n0,10\n1,10\n2,10\n3,10\n");
  ASSERT_EQ(run("replay logs --model model.toml --table t.csv --json all.json"), 0) << err_;
  const auto table = rows("t.csv");
  const auto all = json("all.json")["profiles"];
  ASSERT_EQ(all.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    const std::string name = table[i].at("profile");
    EXPECT_EQ(all[i]["profile"], name);
    EXPECT_EQ(all[i]["model"], "model.toml");
    ASSERT_EQ(run("replay logs/" + name + " --model model.toml --json alone.json"), 0) << err_;
    EXPECT_EQ(all[i]["result"], json("alone.json")) << name;
    expect_same(table[i], json("alone.json"));
  }
  EXPECT_EQ(table[2].at("flags"), "overload negative_tension gap");
  EXPECT_EQ(table[2].at("missing_samples"), "6");
  EXPECT_EQ(table[3].at("repeats_to_B10"), "inf");
  EXPECT_NE(table[3].at("warnings").find("about 1 Hz"), std::string::npos);
}

TEST_F(TableProgram, TakesFilesAndFoldersAsTheyAreGiven) {
  ASSERT_EQ(run("replay good.csv logs/r10 logs/r2/day9.csv --model model.toml --table t.csv"), 0)
      << err_;
  EXPECT_EQ(column(rows("t.csv"), "profile"),
            (Names{"good.csv", "logs/r10/day1.csv", "logs/r2/day9.csv"}));
  ASSERT_EQ(run("replay good.csv --model model.toml --table t.csv --json one.json"), 0) << err_;
  EXPECT_EQ(column(rows("t.csv"), "profile"), Names{"good.csv"});
  EXPECT_EQ(json("one.json")["profiles"].size(), 1U);
  EXPECT_FALSE(json("one.json")["profiles"][0].contains("error"));
}

TEST_F(TableProgram, IsTheSameForAnyNumberOfThreads) {
  for (int i = 0; i < 40; ++i) {
    write_profile("logs/r" + std::to_string(i % 7) + "/p" + std::to_string(i) + ".csv", 20 + i);
  }
  write("logs/bad.csv", "time_s\n");
  for (const std::string threads : {"1", "2", "7"}) {
    EXPECT_EQ(run("replay logs --model model.toml --threads " + threads + " --table " + threads +
                  ".csv --json " + threads + ".json"),
              1);
  }
  EXPECT_EQ(rows("1.csv").size(), 44U);
  EXPECT_EQ(contents(folder_ / "2.csv"), contents(folder_ / "1.csv"));
  EXPECT_EQ(contents(folder_ / "7.csv"), contents(folder_ / "1.csv"));
  EXPECT_EQ(contents(folder_ / "2.json"), contents(folder_ / "1.json"));
  EXPECT_EQ(contents(folder_ / "7.json"), contents(folder_ / "1.json"));
}

TEST_F(TableProgram, TakesTheNearestModel) {
  copy_model("logs/model.toml", "1.0e5");
  copy_model("logs/r2/model.toml", "2.0e4");
  write_profile("logs/r2/deep/down/x.csv", 60);
  ASSERT_EQ(run("replay logs --table t.csv"), 0) << err_;
  const auto table = rows("t.csv");
  EXPECT_EQ(column(table, "profile"),
            (Names{"r2/day9.csv", "r2/day10.csv", "r2/deep/down/x.csv", "r10/day1.csv"}));
  EXPECT_EQ(column(table, "model"),
            (Names{"r2/model.toml", "r2/model.toml", "r2/model.toml", "model.toml"}));
  EXPECT_NEAR(std::stod(table[0].at("damage_total")) / life_used(60, 2e4), 1, 1e-4);
  EXPECT_NEAR(std::stod(table[2].at("damage_total")) / life_used(60, 2e4), 1, 1e-4);
  EXPECT_NEAR(std::stod(table[3].at("damage_total")) / life_used(40, 1e5), 1, 1e-4);

  ASSERT_EQ(run("replay logs/r10 logs/r2/day9.csv good.csv --table t.csv"), 1);
  EXPECT_EQ(column(rows("t.csv"), "model"), (Names{"", "logs/r2/model.toml", "model.toml"}))
      << "a folder above the one that is given is not looked into";

  ASSERT_EQ(run("replay logs --model model.toml --table t.csv"), 0) << err_;
  EXPECT_EQ(column(rows("t.csv"), "model"), Names(4, "model.toml"));
  EXPECT_NEAR(std::stod(rows("t.csv")[0].at("damage_total")) / life_used(60), 1, 1e-4);
}

TEST_F(TableProgram, TellsOfABadModelOnceButInEachRow) {
  copy_model("logs/model.toml", "1.0e5");
  write("logs/r2/model.toml", "schema = 1\nnonsense = 1\n");
  EXPECT_EQ(run("replay logs --table t.csv"), 1);
  EXPECT_EQ(std::count(err_.begin(), err_.end(), '\n'), 1) << err_;
  EXPECT_EQ(err_.rfind("logs/r2/model.toml:2:", 0), 0U) << err_;
  const auto table = rows("t.csv");
  EXPECT_EQ(table[0].at("error") + "\n", err_);
  EXPECT_EQ(table[1].at("error") + "\n", err_);
  EXPECT_EQ(table[2].at("error"), "");
  // Neither a link that leads nowhere: the model of all is not that of this robot.
  fs::remove(folder_ / "logs/r2/model.toml");
  fs::create_symlink("nowhere.toml", folder_ / "logs/r2/model.toml");
  EXPECT_EQ(run("replay logs --table t.csv"), 1);
  EXPECT_NE(rows("t.csv")[0].at("error"), "");
}

TEST_F(TableProgram, MayGoToStandardOutputAlone) {
  ASSERT_EQ(run("replay logs --model model.toml --table -"), 0) << err_;
  EXPECT_EQ(rows_of(out_).size(), 3U);
  EXPECT_NE(err_.find("3 profiles replayed"), std::string::npos) << err_;
}

TEST_F(TableProgram, FindsProfilesWhereverTheyAreButNoHiddenOnes) {
  write_profile("logs/r2/.trash/old.csv", 60);
  write_profile("logs/r2/._day9.csv", 60);
  write_profile("logs/r3/DAY.CSV", 60);
  write_profile("logs/a, \"b\".csv", 60);
  write("logs/r3/notes.txt", "no profile");
  fs::create_directory_symlink("..", folder_ / "logs/r3/above");
  fs::create_directory_symlink("../r10", folder_ / "logs/r3/linked");
  ASSERT_EQ(run("replay logs --model model.toml --table t.csv"), 0) << err_;
  EXPECT_EQ(column(rows("t.csv"), "profile"),
            (Names{"a, \"b\".csv", "r2/day9.csv", "r2/day10.csv", "r3/DAY.CSV",
                   "r3/linked/day1.csv", "r10/day1.csv"}));
}

TEST_F(TableProgram, LeavesOutTablesOfEarlierRuns) {
  ASSERT_EQ(run("replay logs --model model.toml --table logs/fleet.csv"), 0) << err_;
  const std::string first = contents(folder_ / "logs/fleet.csv");
  ASSERT_EQ(run("replay logs --model model.toml --table logs/fleet.csv"), 0) << err_;
  EXPECT_EQ(contents(folder_ / "logs/fleet.csv"), first);
  ASSERT_EQ(run("replay logs --model model.toml --table logs/tomorrow.csv"), 0) << err_;
  EXPECT_EQ(contents(folder_ / "logs/tomorrow.csv"), first);
}

TEST_F(TableProgram, TakesTheColumnsThatAreAskedFor) {
  const std::string both = "time_s,input_tension_N,motor_current_A\n0,10,1\n0.005,60,2\n";
  write("logs/r2/day9.csv", both);
  write("logs/r2/day10.csv", both);
  ASSERT_EQ(run("replay logs/r2 --model model.toml --input motor_current --table t.csv"), 0)
      << err_;
  EXPECT_EQ(column(rows("t.csv"), "input"), Names(2, "motor_current"));
}

}  // namespace
