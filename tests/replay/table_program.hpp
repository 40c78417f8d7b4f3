#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/replay/program.hpp"

namespace host_sim_test {

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

}  // namespace host_sim_test
