#include "tests/replay/program.hpp"

#include <nlohmann/json.hpp>
#include <utility>

namespace {

using nlohmann::json;

class FleetProgram : public host_sim_test::Program {
 protected:
  void SetUp() override {
    Program::SetUp();
    write("fleet.csv",
          "tendon,damage,damage_per_h,hours_per_day\n"
          "old,0.68464,1e-3,10\n"  // at B10
          "new,0,1e-3,10\n"
          "idle,0.5,1e-3,0\n");
  }

  json plan_of(const std::string& arguments) {
    EXPECT_EQ(run("fleet fleet.csv --model model.toml --json plan.json " + arguments), 0) << err_;
    return json::parse(host_sim_test::contents(folder_ / "plan.json"));
  }
};

TEST_F(FleetProgram, PlansByHand) {
  // Ten days of 0.01: (0.78464^5.94 - 0.68464^5.94) = 0.2368 - 0.1054.
  const json plan = plan_of("--today 2026-03-02 --horizon 10d");
  const json& old = plan["tendons"][0];
  EXPECT_NEAR(old["risk"], 0.1232, 2e-4);
  EXPECT_NEAR(old["risk_at_fit"], 0.1232, 2e-4);
  // 10 % after a further 0.0847: 84.7 hours, 8 whole days.
  EXPECT_NEAR(old["replace"]["hours"], 84.7, 0.1);
  EXPECT_EQ(old["replace"]["date"], "2026-03-10");
  EXPECT_EQ(old["due"], true);
  // B10 of a new one after 684.6 hours, 68 whole days.
  const json& fresh = plan["tendons"][1];
  EXPECT_NEAR(fresh["b10"]["hours"], 684.64, 0.01);
  EXPECT_EQ(fresh["b10"]["date"], "2026-05-09");
  EXPECT_EQ(fresh["replace"]["date"], "2026-05-09");
  EXPECT_EQ(fresh["due"], false);
  const json& idle = plan["tendons"][2];
  EXPECT_EQ(idle["risk"], 0);
  EXPECT_EQ(idle["replace"]["date"], nullptr);
  EXPECT_EQ(plan["due"], 1);
  // The old one breaks with 12.3 %: none is enough with 87.7 %, one with all but 1e-6.
  EXPECT_EQ(plan["spares"]["run_to_break"]["count"], 1);
  EXPECT_EQ(plan_of("--horizon 10d --service 0.87")["spares"]["run_to_break"]["count"], 0);
  EXPECT_EQ(plan["spares"]["on_condition"]["count"], 1);
  EXPECT_NE(out_.find("REPLACE"), std::string::npos) << out_;
}

TEST_F(FleetProgram, CountsHoursOfOperationWhereTheHorizonDoes) {
  const json plan = plan_of("--today 2026-03-02 --horizon 684.64h");
  EXPECT_NEAR(plan["tendons"][1]["risk"], 0.1, 1e-4);
  EXPECT_GT(plan["tendons"][2]["risk"], 0.1);
  EXPECT_EQ(plan["horizon_h"], 684.64);
}

TEST_F(FleetProgram, GivesTheSameBytesAgainOnAnyNumberOfThreads) {
  const std::string table = EXAMPLES "/fleet/tendons.csv";
  const auto bytes = [&](const std::string& threads) {
    EXPECT_EQ(run("fleet '" + table +
                  "' --model model.toml --today 2026-03-02 --table t.csv "
                  "--json t.json --threads " +
                  threads),
              0)
        << err_;
    return host_sim_test::contents(folder_ / "t.csv") +
           host_sim_test::contents(folder_ / "t.json") + out_;
  };
  const std::string once = bytes("1");
  EXPECT_EQ(bytes("1"), once);
  EXPECT_EQ(bytes("5"), once);
}

TEST_F(FleetProgram, EachTendonMayHaveItsOwnModel) {
  std::filesystem::create_directory(folder_ / "f");
  std::filesystem::rename(folder_ / "model.toml", folder_ / "f/steel.toml");
  write("f/t.csv",
        "tendon,damage,damage_per_h,hours_per_day,model\n"
        "a,0.1,1e-3,10,steel.toml\nb,0.1,1e-3,10,\n");
  EXPECT_EQ(run("fleet f/t.csv"), 1);
  EXPECT_EQ(err_,
            "f/t.csv: tendon 'b' has no model; accepted: --model for all, or a model in the column "
            "model of each row\n");
  EXPECT_EQ(run("fleet f/t.csv --model f/steel.toml --table -"), 0) << err_;
  EXPECT_NE(out_.find("\na,f/steel.toml,0.1,"), std::string::npos) << out_;
  EXPECT_EQ(run("fleet f/t.csv --model f/steel.toml --json f/steel.toml"), 1);
  EXPECT_NE(err_.find("would overwrite"), std::string::npos) << err_;
}

TEST_F(FleetProgram, TellsWhatThePoliciesCost) {
  const std::string plan = "fleet fleet.csv --model model.toml --today 2026-03-02 --horizon 10d ";
  EXPECT_EQ(run(plan + "--cost-replacement 100 --cost-break 1000 --json p.json"), 0) << err_;
  const json costs = json::parse(host_sim_test::contents(folder_ / "p.json"))["costs"];
  // The old one is due at 0.1, and breaks with 0.1232 until the horizon.
  EXPECT_NEAR(costs["run_to_break"]["cost"], 123.2, 0.2);
  EXPECT_NEAR(costs["at_b10"]["cost"], 100, 0.1);
  EXPECT_NEAR(costs["on_condition"]["cost"], 190, 0.1);
  EXPECT_LT(costs["cheapest"]["cost_per_year"], costs["at_b10"]["cost_per_year"]);
  EXPECT_NE(out_.find("In the long run it is cheapest to replace a tendon at the damage before "
                      "which"),
            std::string::npos)
      << out_;
  const auto before = files();
  EXPECT_EQ(run(plan + "--cost-break 1000 --json q.json"), 1);
  EXPECT_EQ(err_,
            "fleet.csv: tendon 'old' has no cost_replace; accepted: --cost-replacement for all, or "
            "cost_replace of each tendon\n");
  EXPECT_EQ(run(plan + "--cost-replacement 100 --cost-break 99 --json q.json"), 1);
  EXPECT_EQ(run(plan + "--cost-replacement -1 --cost-break 99 --json q.json"), 2);
  EXPECT_EQ(files(), before);
  EXPECT_EQ(run(plan + "--json p.json"), 0);
  EXPECT_EQ(json::parse(host_sim_test::contents(folder_ / "p.json"))["costs"], nullptr);
}

TEST_F(FleetProgram, ReadsAFolderOfRecords) {
  ASSERT_EQ(run("replay '" EXAMPLES "/upper_arm.csv' --model model.toml --can run.log"), 0) << err_;
  std::filesystem::create_directory(folder_ / "rec");
  ASSERT_EQ(run("monitor --log run.log --once --record rec/robot1"), 0) << err_;
  const std::string log = host_sim_test::contents(folder_ / "rec/robot1/frames-00000001.log");
  // A line that is being written, or was cut off with the power, is none yet.
  write("rec/robot1/frames-00000001.log", log + log.substr(0, 25));
  std::filesystem::rename(folder_ / "run.log", folder_ / "rec/robot2.log");
  const std::string model = " --model model.toml --today 2026-03-02 ";
  ASSERT_EQ(run("fleet rec --hours-per-day 8 --json p.json --write-table t.csv" + model), 0)
      << err_;
  const json plan = json::parse(host_sim_test::contents(folder_ / "p.json"));
  ASSERT_EQ(plan["tendons"].size(), 2U);
  const json& tendon = plan["tendons"][0];
  EXPECT_EQ(tendon["tendon"], "robot1/1/0");
  EXPECT_EQ(plan["tendons"][1]["tendon"], "robot2.log/1/0");
  EXPECT_EQ(tendon["hours_per_day"], 8);
  // What the replay of the same minute gives: 0.0209475, of which the last second is not reported.
  EXPECT_NEAR(tendon["damage"], 0.02095, 4e-4);
  EXPECT_NEAR(tendon["damage_per_h"], 0.02095 * 60, 0.1);
  EXPECT_EQ(tendon["damage"], plan["tendons"][1]["damage"]);
  // The table that was read, read again.
  ASSERT_EQ(run("fleet t.csv --json again.json" + model), 0) << err_;
  const json again = json::parse(host_sim_test::contents(folder_ / "again.json"));
  EXPECT_EQ(again["tendons"], plan["tendons"]);
  EXPECT_EQ(run("fleet rec/robot1 --hours-per-day 8" + model), 0) << err_;
  EXPECT_NE(out_.find("robot1/1/0"), std::string::npos) << out_;
}

TEST_F(FleetProgram, TellsFoldersThatAreNoRecords) {
  std::filesystem::create_directory(folder_ / "rec");
  const std::string rest = " --model model.toml --json p.json --write-table t.csv --hours-per-day ";
  const std::string accepted =
      "; accepted: a folder of records, each a folder of monitor --record or a log (.log, .asc, "
      ".pcap, .pcapng)\n";
  const auto before = files();
  EXPECT_EQ(run("fleet rec" + rest + "8"), 1);
  EXPECT_EQ(err_, "rec: no records in this folder" + accepted);
  write("rec/a.log", "(1.000000) can0 123#00\n");
  EXPECT_EQ(run("fleet rec" + rest + "8"), 1);
  EXPECT_EQ(err_,
            "a.log: no damage of a tendon in this record; accepted: frames of a controller, of "
            "which LifeDetail page 3 has the damage\n");
  write("rec/a.log", "(1.000000) can0 123#00\nnone\n");
  EXPECT_EQ(run("fleet rec" + rest + "8"), 1);
  EXPECT_EQ(err_.substr(0, 12), "rec/a.log:2:") << err_;
  EXPECT_EQ(run("fleet rec --model model.toml"), 2);
  EXPECT_NE(err_.find("give --hours-per-day"), std::string::npos) << err_;
  EXPECT_EQ(run("fleet rec" + rest + "25"), 2);
  EXPECT_EQ(run("fleet fleet.csv" + rest + "8"), 2);
  EXPECT_NE(err_.find("--hours-per-day: a table has its own column"), std::string::npos) << err_;
  EXPECT_EQ(run("fleet nothing" + rest + "8"), 1);
  EXPECT_EQ(err_.substr(0, 8), "nothing:") << err_;
  EXPECT_EQ(run("fleet rec --json rec/a.log --hours-per-day 8 --model model.toml"), 1);
  EXPECT_NE(err_.find("would overwrite"), std::string::npos) << err_;
  EXPECT_EQ(files(), before);
}

TEST_F(FleetProgram, TellsOptionsThatDoNotFit) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"--horizon 0d", "--horizon: '0d' is none; accepted: days, weeks or months"},
      {"--horizon soon", "hours of operation (2000h), or a date after --today"},
      {"--today 2026-03-02 --horizon 2026-03-01", "--horizon: '2026-03-01' is none"},
      {"--today 2026-02-30", "--today: '2026-02-30' is none; accepted: a date from 1970-01-01"},
      {"--service 0", "--service: 0 is not a number from 1e-06 to 0.999999"},
      {"--service 1.5", "--service"},
      {"--service nan", "--service"},
      {"--risk 0", "--risk"},
      {"--risk 1", "--risk"},
  };
  const auto before = files();
  for (const auto& [arguments, message] : cases) {
    EXPECT_EQ(run("fleet fleet.csv --model model.toml --json p.json " + arguments), 2) << arguments;
    EXPECT_NE(err_.find(message), std::string::npos) << arguments << '\n' << err_;
    EXPECT_EQ(out_, "") << arguments;
    EXPECT_EQ(files(), before) << arguments;
  }
}

TEST_F(FleetProgram, ATableThatCannotBeTrustedLeavesNothingBehind) {
  write("bad.csv", "tendon,damage,damage_per_h,hours_per_day\na,-1,1e-3,8\n");
  const auto before = files();
  EXPECT_EQ(run("fleet bad.csv --model model.toml --json p.json --table p.csv"), 1);
  EXPECT_EQ(err_, "bad.csv:2:3: damage is '-1', out of range; accepted: 0..100\n");
  EXPECT_EQ(files(), before);
}

}  // namespace
