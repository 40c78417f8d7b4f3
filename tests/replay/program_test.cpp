#include "tests/replay/program.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "lifemodel/extension/extended_block.hpp"

namespace {

namespace fs = std::filesystem;
using host_sim_test::contents;
using host_sim_test::Program;
using host_sim_test::with;

TEST_F(Program, ReplaysTheExampleOfThePapersUpperArm) {
  ASSERT_EQ(run("replay '" EXAMPLES "/upper_arm.csv' --model '" EXAMPLES
                "/upper_arm.toml' --json result.json --trajectory damage.csv --report page.html"),
            0)
      << err_;
  EXPECT_EQ(files(), (std::vector<std::string>{"damage.csv", "good.csv", "model.toml", "page.html",
                                               "result.json"}));
  const auto json = nlohmann::json::parse(contents(folder_ / "result.json"));
  EXPECT_EQ(json["input"], "output_tension");
  EXPECT_EQ(json["duration_s"].get<double>(), 60);
  // 20 turns of the crank, half-way to begin and to end with; the paper's application has 39.9 N.
  EXPECT_EQ(2 * json["cycles"]["closed"].get<int>() + json["cycles"]["open_half"].get<int>(), 40);
  EXPECT_NEAR(json["equivalent_effective_tension_N"].get<double>(), 39.9, 0.4);
  EXPECT_LT(std::fabs(json["relative_error"].get<double>()), 1e-5);
  EXPECT_TRUE(json["flags"].empty());
  EXPECT_NE(out_.find("life used"), std::string::npos);
  EXPECT_NE(contents(folder_ / "page.html").find("</html>"), std::string::npos);
}

/// A profile long enough to be parsed in many parts.
TEST_F(Program, TheNumberOfThreadsChangesNoByte) {
  std::string profile = "time_s,input_tension_N\n";
  for (int i = 0; i < 60'000; ++i) {
    profile +=
        std::to_string(i * 0.005) + ',' + std::to_string(60 + 50 * std::sin(0.1 * i * i)) + '\n';
  }
  write("long.csv", profile);
  const auto outputs_of = [&](const std::string& options) {
    EXPECT_EQ(run("replay long.csv --model model.toml --json - --trajectory damage.csv "
                  "--report page.html" +
                  options),
              0)
        << err_;
    return std::vector<std::string>{out_, contents(folder_ / "damage.csv"),
                                    contents(folder_ / "page.html")};
  };
  const auto expected = outputs_of(" --threads 1");
  for (const char* options : {"", " --threads 2", " --threads 3", " --threads 100"}) {
    EXPECT_EQ(outputs_of(options), expected) << options;
  }
}

TEST_F(Program, BadInputIsOneLineWithFileAndLineAndLeavesNothingBehind) {
  struct Bad {
    const char* profile;
    const char* line;
  };
  for (const Bad& bad : {Bad{"time_s,input_tension_N\n0,1\n1,nan\n", "bad.csv:3:"},
                         Bad{"time_s,input_tension_N\n0,1\n1,inf\n", "bad.csv:3:"},
                         Bad{"time_s,input_tension_N\n0,1\n2,3\n1,2\n", "bad.csv:4:"},
                         Bad{"time_s,input_tension_kN\n0,1\n", "bad.csv:1:"},
                         Bad{"input_tension_N\n1\n", "bad.csv:1"},
                         Bad{"time_s,input_tension_N\n0,1\n1\n", "bad.csv:3"}, Bad{"", "bad.csv"},
                         Bad{"time_s,input_tension_N\n", "bad.csv"}}) {
    write("bad.csv", bad.profile);
    const auto before = files();
    EXPECT_EQ(
        run("replay bad.csv --model model.toml --json r.json --trajectory t.csv --report p.html"),
        1)
        << bad.profile;
    EXPECT_EQ(std::count(err_.begin(), err_.end(), '\n'), 1) << err_;
    EXPECT_EQ(err_.rfind(bad.line, 0), 0u) << err_;
    EXPECT_NE(err_.find("accepted"), std::string::npos) << err_;
    EXPECT_TRUE(out_.empty());
    EXPECT_EQ(files(), before);
  }
}

// tests/replay/given_survival_test.cpp has the numbers.
TEST_F(Program, TellsLifeGivenSurvival) {
  ASSERT_EQ(run("replay good.csv --model model.toml --used 0.684648495 --horizon 8h --json r.json"),
            0)
      << err_;
  const auto json = nlohmann::json::parse(contents(folder_ / "r.json"));
  const auto& given = json["given_survival"];
  const double each = json["damage"]["total"];
  EXPECT_NEAR(given["repeats_to"]["10_percent"]["value"], 0.0847407 / each,
              1e-5 * 0.0847407 / each);
  EXPECT_TRUE(given["repeats_to"]["10_percent"]["interval"].is_null());
  EXPECT_NEAR(given["break_risk"]["repeats"], 8 * 3600 / json["duration_s"].get<double>(), 1);
  EXPECT_NE(out_.find("whole now     at damage 0.684648"), std::string::npos) << out_;
  EXPECT_NE(out_.find("risk of a break within 8h"), std::string::npos) << out_;
  ASSERT_EQ(run("replay good.csv --model model.toml --json r.json"), 0);
  EXPECT_FALSE(nlohmann::json::parse(contents(folder_ / "r.json")).contains("given_survival"));
}

TEST_F(Program, AHorizonOfNoneIsRefusedInALine) {
  for (const char* bad : {"0", "0h", "-1", "soon"}) {
    EXPECT_EQ(run(std::string("replay good.csv --model model.toml --json r.json --horizon=") + bad),
              2);
    EXPECT_NE(err_.find(std::string(bad) + " is no horizon; accepted: repeats or hours above 0"),
              std::string::npos)
        << err_;
    EXPECT_FALSE(fs::exists(folder_ / "r.json"));
  }
  EXPECT_EQ(run("replay good.csv --model model.toml --used=-0.1"), 2);
}

// tests/replay/until_date_test.cpp has the numbers.
TEST_F(Program, TellsWhatLastsUntilADate) {
  ASSERT_EQ(run("replay good.csv --model model.toml --json r.json"), 0) << err_;
  const auto whole = nlohmann::json::parse(contents(folder_ / "r.json"));
  const double hours =
      whole["repeats_to"]["B10"].get<double>() * whole["duration_s"].get<double>() / 3600;
  // A day of twice that.
  ASSERT_EQ(run("replay good.csv --model model.toml --until-date 2026-11-23 --today 2026-11-22 "
                "--hours-per-day " +
                nlohmann::json(2 * hours).dump() + " --risk 0.1 --json r.json --report page.html"),
            0)
      << err_;
  const auto json = nlohmann::json::parse(contents(folder_ / "r.json"))["until_date"];
  EXPECT_EQ(json["days"], 1);
  EXPECT_EQ(json["lasts_as_it_is"], false);
  EXPECT_NEAR(json["as_it_is"]["hours_to_risk"], hours, 1e-5 * hours);
  EXPECT_NEAR(json["pace"], 0.5, 1e-4);
  EXPECT_NEAR(json["life_gained"], 2, 1e-3);
  EXPECT_LT(json["highest_tension_N"], json["peak_tension_N"]);
  EXPECT_NE(out_.find("until date    2026-11-23: 1 day of"), std::string::npos) << out_;
  EXPECT_NE(out_.find("lasts with a peak of"), std::string::npos) << out_;
  EXPECT_NE(contents(folder_ / "page.html").find("<h2 id=\"until-heading\">Until 2026-11-23</h2>"),
            std::string::npos);
}

TEST_F(Program, AWantedDateThatCannotBeIsRefusedInALine) {
  struct Bad {
    const char* options;
    int status;
    const char* says;
  };
  for (const Bad& bad :
       {Bad{"--until-date 2026-11-22 --today 2026-11-22", 2,
            "--until-date: '2026-11-22' is no day to come; accepted: a date after today, "
            "2026-11-22, "
            "by up to 100 years (YYYY-MM-DD)"},
        Bad{"--until-date 2027-02-30 --today 2026-11-22", 2,
            "--until-date: '2027-02-30' is none; accepted: a date after today"},
        Bad{"--until-date 2127-06-30 --today 2026-11-22", 2, "by up to 100 years"},
        Bad{"--until-date 2027-06-30 --today soon", 2, "--today: 'soon' is none; accepted: a date"},
        Bad{"--until-date 2027-06-30 --risk 1", 2, "--risk: "},
        Bad{"--until-date 2027-06-30 --risk 0", 2, "--risk: "},
        Bad{"--until-date 2027-06-30 --hours-per-day 25", 2, "--hours-per-day: "},
        Bad{"--risk 0.1", 2, "--risk requires --until-date"},
        Bad{"--until-date 2126-06-30 --today 2026-11-22 --used 0.6", 1,
            "good.csv: no tension lets a wire at damage 0.6 last until 2126-06-30: "}}) {
    EXPECT_EQ(run(std::string("replay good.csv --model model.toml --json r.json --report p.html ") +
                  bad.options),
              bad.status)
        << bad.options;
    EXPECT_NE(err_.find(bad.says), std::string::npos) << err_;
    // Of the command line with where to find help.
    EXPECT_EQ(std::count(err_.begin(), err_.end(), '\n'), bad.status) << err_;
    EXPECT_TRUE(out_.empty());
    EXPECT_FALSE(fs::exists(folder_ / "r.json") || fs::exists(folder_ / "p.html"));
  }
}

TEST_F(Program, BadModelsAreRefusedWithTheLine) {
  write("unknown.toml", contents(folder_ / "model.toml") + "\n[cable2]\nx = 1\n");
  EXPECT_EQ(run("replay good.csv --model unknown.toml"), 1);
  EXPECT_EQ(err_.rfind("unknown.toml:", 0), 0u) << err_;
  EXPECT_EQ(run("replay good.csv --model absent.toml"), 1);
  EXPECT_EQ(err_.rfind("absent.toml", 0), 0u) << err_;
  EXPECT_EQ(run("replay absent.csv --model model.toml"), 1);
  EXPECT_EQ(err_.rfind("absent.csv", 0), 0u) << err_;
}

TEST_F(Program, ModelsThatTheBoardCannotRepresentAreRefusedWithWhatItAccepts) {
  const std::string model = contents(folder_ / "model.toml");
  struct Bad {
    std::string model;
    const char* accepted;
  };
  // 177.4^1.38 = 1269.3, over and times 2^500 = 3.2734e150; 177.4 N * 2^-37 and * 2^25.
  const std::vector<Bad> all{
      {with(model, "ipl_scale", "1e300"), "ipl_scale 3.88e-148..4.15e+153 with"},
      {with(model, "ipl_scale", "1e-300"), "ipl_scale 3.88e-148..4.15e+153 with"},
      {with(with(with(model, "torque_constant_Nm_per_A", "100"), "gear_ratio", "10000"),
            "spool_radius_mm", "0.1"),
       "1.29e-09..5.95e+09 N/A"},
      {with(with(with(model, "torque_constant_Nm_per_A", "1e-6"), "gear_ratio", "0.001"),
            "spool_radius_mm", "1000"),
       "1.29e-09..5.95e+09 N/A"},
      {with(with(model, "ultimate_tension_N", "100"), "hysteresis_N", "99.99999999"),
       "hysteresis_N below"}};
  for (const Bad& bad : all) {
    write("bad.toml", bad.model);
    const auto before = files();
    for (const char* verb :
         {"replay good.csv --model bad.toml --json r.json", "pack bad.toml --out block.bin"}) {
      EXPECT_EQ(run(verb), 1) << bad.accepted;
      EXPECT_EQ(err_.rfind("bad.toml: the board cannot represent it: ", 0), 0u) << err_;
      EXPECT_NE(err_.find("; accepted: "), std::string::npos) << err_;
      EXPECT_NE(err_.find(bad.accepted), std::string::npos) << err_;
      EXPECT_EQ(std::count(err_.begin(), err_.end(), '\n'), 1) << err_;
      EXPECT_EQ(files(), before);
    }
  }
}

TEST_F(Program, AnOutputThatCannotBeWrittenIsFoundBeforeTheWork) {
  EXPECT_EQ(run("replay good.csv --model model.toml --json no/such/folder/r.json"), 1);
  EXPECT_NE(err_.find("no/such/folder/r.json"), std::string::npos) << err_;
  EXPECT_EQ(std::count(err_.begin(), err_.end(), '\n'), 1) << err_;
}

TEST_F(Program, AnErrorKeepsAnEarlierResult) {
  ASSERT_EQ(run("replay good.csv --model model.toml --json r.json"), 0) << err_;
  const std::string before = contents(folder_ / "r.json");
  write("bad.csv", "time_s,input_tension_N\n0,1\n1,x\n");
  EXPECT_EQ(run("replay bad.csv --model model.toml --json r.json"), 1);
  EXPECT_EQ(contents(folder_ / "r.json"), before);
}

TEST_F(Program, AnInterruptionLeavesNothingBehind) {
  const auto before = files();
  // Rows without end, and a signal once the replay is under way.
  const std::string command =
      "cd '" + folder_.string() +
      "' && awk 'BEGIN { print \"time_s,input_tension_N\"; for (i = 0;; i++) print i \",\" i % 50 "
      "}' 2> /dev/null | timeout --preserve-status -s INT 1 '" HOST_SIM
      "' replay - --model model.toml --json r.json --trajectory t.csv --report p.html --can c.log "
      "2> err.txt";
  const int status = std::system(command.c_str());
  EXPECT_EQ(WEXITSTATUS(status), 130);
  EXPECT_NE(contents(folder_ / "err.txt").find("interrupted"), std::string::npos);
  fs::remove(folder_ / "err.txt");
  EXPECT_EQ(files(), before);
}

TEST_F(Program, WrongUsageIsStatusTwo) {
  EXPECT_EQ(run(""), 2);
  EXPECT_EQ(run("replay good.csv"), 2);
  EXPECT_EQ(run("frobnicate"), 2);
  EXPECT_EQ(run("replay good.csv --model model.toml --fail-on nonsense"), 2);
  EXPECT_EQ(run("replay good.csv --model model.toml --json x --report x"), 2);
  EXPECT_EQ(run("replay --help"), 0);
  EXPECT_NE(out_.find("Example: host_sim replay"), std::string::npos);
  EXPECT_EQ(run("--version"), 0);
}

TEST_F(Program, FailsOnAFlagOnlyWhenAsked) {
  write("overload.csv", "time_s,input_tension_N\n0,10\n0.005,190\n0.01,10\n");
  EXPECT_EQ(run("replay overload.csv --model model.toml"), 0);
  EXPECT_NE(out_.find("overload"), std::string::npos);
  EXPECT_EQ(run("replay overload.csv --model model.toml --fail-on gap"), 0);
  EXPECT_EQ(run("replay overload.csv --model model.toml --fail-on gap,overload"), 3);
  EXPECT_EQ(run("replay overload.csv --model model.toml --fail-on any --json r.json"), 3);
  EXPECT_TRUE(fs::exists(folder_ / "r.json")) << "the result is there all the same";
}

TEST_F(Program, JsonOnStandardOutputIsJsonAlone) {
  ASSERT_EQ(run("replay good.csv --model model.toml --json -"), 0);
  EXPECT_EQ(nlohmann::json::parse(out_)["samples"], 4);
  EXPECT_NE(err_.find("life used"), std::string::npos);
}

TEST_F(Program, PacksWhatTheFirmwareReads) {
  ASSERT_EQ(run("pack model.toml --out block.bin"), 0) << err_;
  const std::string bytes = contents(folder_ / "block.bin");
  const auto parameters = lifemodel::decode(std::as_bytes(std::span(bytes.data(), bytes.size())));
  ASSERT_TRUE(parameters) << lifemodel::to_string(parameters.error());
  EXPECT_EQ(parameters->ultimate_mN, 177'400u);
  EXPECT_EQ(parameters->sample_period_us, 5000u);
  EXPECT_TRUE(parameters->has_drive());
  ASSERT_EQ(run("pack model.toml --out block.h --format c"), 0) << err_;
  EXPECT_NE(contents(folder_ / "block.h").find("tendonlife_parameter_block[84]"),
            std::string::npos);
}

TEST_F(Program, PacksWhatTheFirmwareWatches) {
  write("watched.toml", contents(folder_ / "model.toml") +
                            "\n[watch]\nminimum_tension_N = 1.5\nslack_travel_mm = 3\n"
                            "broken_tension_N = 4\nbroken_travel_mm = 25\nadvice_risk = 0.25\n"
                            "advice_until_h = 1000\n");
  ASSERT_EQ(run("pack watched.toml --out block.bin"), 0) << err_;
  const std::string bytes = contents(folder_ / "block.bin");
  const auto model =
      lifemodel::decode_extended(std::as_bytes(std::span(bytes.data(), bytes.size())));
  ASSERT_TRUE(model) << to_string(model.error());
  const lifemodel::WatchLimits& watch = model->nominal.watch;
  EXPECT_EQ(watch.minimum.raw(), 4'539'495);  // 1.5 / 177.4 * 2^29
  EXPECT_EQ(watch.broken.raw(), 12'105'319);
  EXPECT_EQ(watch.broken_travel_um, 25'000u);
  EXPECT_EQ(watch.slack_travel_um, 3'000u);
  EXPECT_EQ(watch.horizon_s, 28'800u);
  EXPECT_EQ(watch.advice_risk.raw(), 1u << 28);
  EXPECT_EQ(watch.advice_until_s, 3'600'000u);
  ASSERT_EQ(run("pack watched.toml --out block.h --format c"), 0) << err_;
  const std::string array = contents(folder_ / "block.h");
  EXPECT_NE(array.find("for lm_init() or lifemodel::decode()"), std::string::npos);
  EXPECT_NE(array.find("tendonlife_parameter_block[128]"), std::string::npos);
}

TEST_F(Program, PacksAndReplaysWhatExtendsTheModel) {
  write("extended.toml", contents(folder_ / "model.toml") +
                             "\n[extension.current_offset]\ncurrent_offset_A = 0.05\n"
                             "[extension.slack]\nslack_log_drop = 0.1\nslack_friction_share = 1\n"
                             "slack_m = 0.001\n");
  ASSERT_EQ(run("pack extended.toml --out block.bin"), 0) << err_;
  EXPECT_NE(err_.find("current_offset: evaluated where motor current is sampled"),
            std::string::npos);
  EXPECT_NE(err_.find("slack: not in the block; not evaluated on line"), std::string::npos);
  const std::string bytes = contents(folder_ / "block.bin");
  const auto model =
      lifemodel::decode_extended(std::as_bytes(std::span(bytes.data(), bytes.size())));
  ASSERT_TRUE(model) << to_string(model.error());
  EXPECT_EQ(model->extension.current_offset.offset, 838861);  // 0.05 * 2^24
  EXPECT_EQ(model->extension.effects, 1u << 1);

  ASSERT_EQ(run("pack extended.toml --without current_offset --out plain.bin"), 0) << err_;
  EXPECT_EQ(contents(folder_ / "plain.bin").size(), lifemodel::kBlockBytes);

  write("current.csv", "time_s,motor_current_A\n0,1\n0.005,3\n0.01,1\n");
  ASSERT_EQ(run("replay current.csv --model extended.toml --json r.json"), 0) << err_;
  const auto json = nlohmann::json::parse(contents(folder_ / "r.json"));
  EXPECT_EQ(json["extensions"], nlohmann::json::array({"current_offset"}));
  EXPECT_EQ(json["not_evaluated"][0]["id"], "slack");
}

// 10 and 60 N in turn: three half cycles of T_a 25 and T_m 35 N, T_eff 26.0125 N.
TEST_F(Program, SpecimensAreTheLivesThatWereSeen) {
  ASSERT_EQ(run("replay good.csv --model model.toml --specimens s.csv"), 0) << err_;
  const std::string head =
      "specimen,lot,input_tension_mean_N,input_tension_amplitude_N,cycles,status\ngood,field,0,";
  const std::string text = contents(folder_ / "s.csv");
  ASSERT_EQ(text.substr(0, head.size()), head);
  EXPECT_NEAR(std::stod(text.substr(head.size())), 26.0125, 1e-3);
  EXPECT_EQ(text.substr(text.find(',', head.size())), ",1.5,suspended\n");
}

TEST_F(Program, ALifeWithoutACycleIsNoSpecimen) {
  write("idle.csv", "time_s,input_tension_N\n0,10\n0.005,10\n0.01,10\n");
  EXPECT_EQ(run("replay idle.csv --model model.toml --specimens s.csv"), 1);
  EXPECT_EQ(
      err_,
      "idle.csv: no cycle, and --specimens is for lives in cycles; accepted: a profile with at "
      "least half a cycle\n");
  EXPECT_FALSE(fs::exists(folder_ / "s.csv"));
}

TEST_F(Program, FailsOnABrokenWireWhereItIsAsked) {
  std::string text = "time_s,input_tension_N,tendon_velocity_m_s\n0,60,0.1\n";
  for (int i = 1; i < 100; ++i) {
    text += std::to_string(i * 0.005) + ",0.1,0.1\n";
  }
  write("cut.csv", text);
  EXPECT_EQ(run("replay cut.csv --model model.toml"), 0) << err_;
  EXPECT_NE(out_.find("break         FOUND: no more than 0.2 N over 21.54 mm"), std::string::npos)
      << out_;
  EXPECT_EQ(run("replay cut.csv --model model.toml --fail-on tendon_broken"), 3);
  EXPECT_EQ(run("replay good.csv --model model.toml --fail-on tendon_broken,tendon_slack"), 0);
}

}  // namespace
