#include <gtest/gtest.h>

#include <algorithm>

#include "tests/replay/interrupted.hpp"
#include "tests/replay/table_program.hpp"

namespace {

using host_sim_test::contents;
using host_sim_test::TableProgram;
using Names = std::vector<std::string>;
namespace fs = std::filesystem;

class RefusedTable : public TableProgram {
 protected:
  /// One line that begins with `place` and says `what`; nothing is left behind.
  void expect_refused(const std::string& arguments, const std::string& place,
                      const std::string& what) {
    const auto before = files();
    EXPECT_EQ(run("replay " + arguments), 1) << arguments;
    EXPECT_EQ(err_.rfind(place + ": ", 0), 0U) << err_;
    EXPECT_NE(err_.find(what), std::string::npos) << err_;
    EXPECT_NE(err_.find("; accepted: "), std::string::npos) << err_;
    EXPECT_EQ(std::count(err_.begin(), err_.end(), '\n'), 1) << err_;
    EXPECT_EQ(out_, "");
    EXPECT_EQ(files(), before);
  }
};

TEST_F(RefusedTable, ABadProfileDoesNotStopTheOthers) {
  write("logs/r2/day10.csv", "time_s,input_tension_N\n0,1\n1,nan\n");
  EXPECT_EQ(run("replay logs --model model.toml --table t.csv --json all.json --fail-on any"), 1);
  EXPECT_EQ(std::count(err_.begin(), err_.end(), '\n'), 1) << err_;
  EXPECT_EQ(err_.rfind("logs/r2/day10.csv:3:", 0), 0U) << err_;
  const auto table = rows("t.csv");
  EXPECT_EQ(column(table, "profile"), (Names{"r2/day9.csv", "r2/day10.csv", "r10/day1.csv"}));
  EXPECT_EQ(column(table, "damage_total")[1], "");
  EXPECT_EQ(table[1].at("error") + "\n", err_);
  EXPECT_EQ(table[1].at("model"), "model.toml");
  EXPECT_EQ(table[0].at("error"), "");
  EXPECT_EQ(table[2].at("samples"), "4");
  const auto all = json("all.json")["profiles"];
  EXPECT_EQ(all[1]["error"], table[1].at("error"));
  EXPECT_FALSE(all[1].contains("result"));
  EXPECT_TRUE(all[2].contains("result"));
  EXPECT_NE(out_.find("2 profiles replayed, 1 refused"), std::string::npos) << out_;
}

TEST_F(RefusedTable, WhatCannotBeOpenedIsInTheTable) {
  fs::create_symlink("nowhere.csv", folder_ / "logs/lost.csv");
  EXPECT_EQ(run("replay logs absent.csv --model model.toml --table t.csv"), 1);
  EXPECT_EQ(std::count(err_.begin(), err_.end(), '\n'), 2) << err_;
  const auto table = rows("t.csv");
  ASSERT_EQ(table.size(), 5U);
  EXPECT_EQ(table[0].at("profile"), "logs/lost.csv");
  EXPECT_NE(table[0].at("error").find("cannot be opened"), std::string::npos);
  EXPECT_EQ(table[4].at("profile"), "absent.csv");
  EXPECT_NE(table[4].at("error").find("cannot be opened"), std::string::npos);
}

TEST_F(RefusedTable, AFolderWithoutProfiles) {
  fs::create_directories(folder_ / "none/below");
  write("none/.hidden.csv", "");
  write("none/profile.txt", "");
  expect_refused("none --model model.toml --table t.csv", "none", "*.csv");
}

TEST_F(RefusedTable, AProfileThatIsNamedTwice) {
  expect_refused("good.csv ./good.csv --model model.toml --table t.csv", "./good.csv", "twice");
  expect_refused("logs logs/r2/day9.csv --model model.toml --table t.csv", "logs/r2/day9.csv",
                 "twice");
  expect_refused("logs logs/r10 --model model.toml --table t.csv", "logs/r10/day1.csv", "twice");
}

TEST_F(RefusedTable, AModelThatNobodyCanUse) {
  expect_refused("logs --table t.csv", "logs", "no model");
  expect_refused("logs --model absent.toml --table t.csv", "absent.toml", "cannot be opened");
  copy_model("huge.toml", "1e300");
  expect_refused("logs --model huge.toml --table t.csv", "huge.toml", "the board cannot");
}

TEST_F(RefusedTable, AnOutputInPlaceOfAProfile) {
  const std::string profile = contents(folder_ / "logs/r2/day9.csv");
  expect_refused("logs --model model.toml --table logs/r2/day9.csv", "logs/r2/day9.csv",
                 "overwrite");
  expect_refused("logs --model model.toml --table t.csv --json logs/r2/../r2/day9.csv",
                 "logs/r2/../r2/day9.csv", "overwrite");
  EXPECT_EQ(contents(folder_ / "logs/r2/day9.csv"), profile);
}

TEST_F(RefusedTable, OptionsForOneProfile) {
  for (const std::string option : {"--trajectory x", "--trajectory-step 1", "--report x", "--can x",
                                   "--can x --node 2", "--start-cycle 0"}) {
    for (const std::string profiles : {"logs", "good.csv logs/r2/day9.csv", "good.csv --table -"}) {
      const auto before = files();
      EXPECT_EQ(run("replay " + profiles + " --model model.toml --json j " + option), 2) << option;
      EXPECT_NE(err_.find(option.substr(0, option.find(' '))), std::string::npos) << err_;
      EXPECT_NE(err_.find("one profile"), std::string::npos) << err_;
      EXPECT_EQ(files(), before);
    }
  }
}

TEST_F(RefusedTable, WrongUsage) {
  EXPECT_EQ(run("replay logs - --model model.toml --table t.csv"), 2);
  EXPECT_NE(err_.find("standard input"), std::string::npos) << err_;
  EXPECT_EQ(run("replay - --model model.toml --table t.csv"), 2);
  EXPECT_EQ(run("replay logs --model model.toml"), 2);
  EXPECT_NE(err_.find("--table"), std::string::npos) << err_;
  EXPECT_EQ(run("replay logs --model model.toml --table t.csv --json t.csv"), 2);
  EXPECT_EQ(run("replay logs --model model.toml --table t.csv --threads 0"), 2);
  EXPECT_EQ(run("replay good.csv"), 2);
  EXPECT_NE(err_.find("--model is required"), std::string::npos) << err_;
}

TEST_F(RefusedTable, FailsOnAFlagOfOneProfileOnlyWhenAsked) {
  write("logs/r2/day9.csv", "time_s,input_tension_N\n0,10\n0.005,190\n0.01,10\n");
  EXPECT_EQ(run("replay logs --model model.toml --table t.csv"), 0) << err_;
  EXPECT_NE(out_.find("overload in 1 of them"), std::string::npos) << out_;
  EXPECT_EQ(run("replay logs --model model.toml --table t.csv --fail-on gap"), 0);
  EXPECT_EQ(run("replay --model model.toml --table t.csv --fail-on gap,overload good.csv logs"), 3)
      << err_;
  EXPECT_EQ(run("replay logs --model model.toml --table t.csv --fail-on any"), 3);
  EXPECT_EQ(rows("t.csv").size(), 3U) << "the table is there all the same";
}

TEST_F(RefusedTable, AnInterruptionLeavesNothingBehind) {
  // Seconds of work.
  std::string rows = "time_s,input_tension_N\n";
  for (int i = 0; i < 100'000; ++i) {
    rows += std::to_string(i) + ',' + std::to_string(i % 50) + '\n';
  }
  write("logs/0.csv", rows);
  for (int i = 1; i < 400; ++i) {
    fs::create_hard_link(folder_ / "logs/0.csv", folder_ / ("logs/" + std::to_string(i) + ".csv"));
  }
  const auto before = files();
  EXPECT_EQ(
      host_sim_test::status_of_interrupted(folder_, {"replay", "logs", "--model", "model.toml",
                                                     "--table", "t.csv", "--json", "all.json"}),
      130);
  EXPECT_EQ(contents(folder_ / "err.txt"), "host_sim: interrupted; no output was written\n");
  fs::remove(folder_ / "err.txt");
  EXPECT_EQ(files(), before);
}

}  // namespace
