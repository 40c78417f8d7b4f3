#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/replay/interrupted.hpp"
#include "tests/replay/program.hpp"

namespace {

using host_sim_test::contents;
using host_sim_test::Program;
using host_sim_test::with;
using Names = std::vector<std::string>;
namespace fs = std::filesystem;

/// host_sim with profiles of two robots in its folder `logs`, and no model there.
class TableProgram : public Program {
 protected:
  using Row = std::map<std::string, std::string>;  ///< by column

  void SetUp() override {
    Program::SetUp();
    write_profile("logs/r10/day1.csv", 40);
    write_profile("logs/r2/day10.csv", 50);
    write_profile("logs/r2/day9.csv", 60);
  }

  /// From 10 N to `high_N`, back, and there again.
  void write_profile(const std::string& name, int high_N) const {
    fs::create_directories((folder_ / name).parent_path());
    const std::string high = std::to_string(high_N) + "\n";
    write(name, "time_s,input_tension_N\n0,10\n0.005," + high + "0.01,10\n0.015," + high);
  }

  void copy_model(const std::string& name, const std::string& ipl_scale) const {
    write(name, with(contents(folder_ / "model.toml"), "ipl_scale", ipl_scale));
  }

  static std::vector<std::string> fields(const std::string& line) {
    std::vector<std::string> all(1);
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (line[i] == '"' && quoted && line.substr(i + 1, 1) == "\"") {
        all.back() += line[++i];
      } else if (line[i] == '"') {
        quoted = !quoted;
      } else if (line[i] == ',' && !quoted) {
        all.emplace_back();
      } else {
        all.back() += line[i];
      }
    }
    EXPECT_FALSE(quoted) << line;
    return all;
  }

  static std::vector<Row> rows_of(const std::string& table) {
    std::istringstream text(table);
    std::string line;
    std::getline(text, line);
    const std::vector<std::string> columns = fields(line);
    std::vector<Row> rows;
    while (std::getline(text, line)) {
      const std::vector<std::string> values = fields(line);
      EXPECT_EQ(values.size(), columns.size()) << line;
      Row& row = rows.emplace_back();
      for (std::size_t i = 0; i < std::min(values.size(), columns.size()); ++i) {
        row[columns[i]] = values[i];
      }
    }
    return rows;
  }

  [[nodiscard]] std::vector<Row> rows(const std::string& name) const {
    return rows_of(contents(folder_ / name));
  }

  static std::vector<std::string> column(const std::vector<Row>& rows, const std::string& name) {
    std::vector<std::string> values;
    for (const Row& row : rows) {
      values.push_back(row.at(name));
    }
    return values;
  }

  [[nodiscard]] nlohmann::json json(const std::string& name) const {
    return nlohmann::json::parse(contents(folder_ / name));
  }
};

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
  EXPECT_NE(out_.find(" in r2/day9.csv"), std::string::npos) << "most damage: " << out_;
}

/// Each number and name of the result of one profile in the column of its name.
void expect_same(const std::map<std::string, std::string>& row, const nlohmann::json& result) {
  std::size_t compared = 0;
  const nlohmann::json flat = result.flatten();
  for (const auto& [pointer, value] : flat.items()) {
    std::string name = pointer.substr(1);
    std::replace(name.begin(), name.end(), '/', '_');
    // Lists and limits have no column; a life without a cycle leaves its own empty.
    if (name.starts_with("flags") || name.starts_with("warnings") ||
        name.starts_with("watch_events") || name.starts_with("watch_limits") ||
        name == "seen_life") {
      continue;
    }
    ++compared;
    const std::string& text = row.at(name);
    if (value.is_null()) {
      EXPECT_EQ(text, "inf") << name;
    } else if (value.is_string()) {
      EXPECT_EQ(text, value.get<std::string>()) << name;
    } else if (value.is_boolean()) {
      EXPECT_EQ(text, value.get<bool>() ? "1" : "0") << name;
    } else {
      EXPECT_EQ(std::stod(text), value.get<double>()) << name;
    }
  }
  EXPECT_EQ(compared, result["seen_life"].is_null() ? 30U : 33U);
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
