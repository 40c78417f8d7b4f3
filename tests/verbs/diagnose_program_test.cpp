#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/verbs/campaign_program.hpp"

namespace {

using host_sim_test::CampaignProgram;
using host_sim_test::contents;
using nlohmann::json;
namespace fs = std::filesystem;

/// Beside the lives of `c`, a campaign `r` of short recordings at two poses.
class DiagnoseProgram : public CampaignProgram {
 protected:
  void SetUp() override {
    CampaignProgram::SetUp();
    write("plan.toml", plan());
    ASSERT_EQ(run("synth --plan plan.toml --out r --seed 5"), 0) << err_;
  }

  static std::string plan() {
    return "schema = 1\n[campaign]\nname = \"short\"\n"
           "[model.cable]\ndiameter_mm = 0.457\nultimate_tension_N = 177.4\n"
           "[model.sheath]\nfriction_coefficient = 0.128\nbend_angle_deg = 270.0\n"
           "[model.counting]\nsample_rate_Hz = 100.0\nhysteresis_N = 0.2\n"
           "[model.life]\nmean_stress = \"gerber\"\nipl_scale = 1.53e5\nipl_exponent = 1.38\n"
           "weibull_shape = 5.94\n"
           "[recordings]\ndesign = \"balanced\"\nsessions = 6\nbend_angles_deg = [90.0, 450.0]\n"
           "output_means_N = [20.0, 35.0]\noutput_amplitudes_N = [5.0, 15.0]\n"
           "frequencies_Hz = [1.0]\ntravels_mm = [20.0]\nsheath_ambients_C = [20.0]\n"
           "winding_starts_C = [20.0]\nstart_cycles = [0.0]\nload_frequency_ratio = 1.3\n"
           "sample_rate_Hz = 50.0\nduration_s = 4.0\n"
           "channels = [\"input_tension_N\", \"output_tension_N\", \"tendon_velocity_m_s\", "
           "\"bend_angle_deg\"]\n"
           "[noise]\nlog_tension_sd = 0.01\n[scatter]\nlog_gain_sd = 0.01\nfriction_sd = 0.006\n";
  }

  /// The program says one line that begins with `place`, and leaves nothing behind.
  void expect_refusal(const std::string& campaign, const std::string& place,
                      const std::string& words) {
    const auto before = files();
    EXPECT_EQ(run("diagnose " + campaign + " --out m.toml --json r.json --report p.html"), 1);
    EXPECT_EQ(std::count(err_.begin(), err_.end(), '\n'), 1) << err_;
    EXPECT_EQ(err_.rfind(place, 0), 0U) << err_;
    EXPECT_NE(err_.find(words), std::string::npos) << err_;
    EXPECT_TRUE(out_.empty()) << out_;
    EXPECT_EQ(files(), before);
  }

  /// All is written but the model, and why not is said in one line at the end.
  void expect_found_without_model(const std::string& model, const std::string& words) {
    EXPECT_EQ(run("diagnose r --out " + model + " --json r.json --report p.html"), 1);
    EXPECT_EQ(err_.rfind(words, 0), 0U) << err_;
    EXPECT_EQ(std::count(err_.begin(), err_.end(), '\n'), 1) << err_;
    EXPECT_FALSE(fs::is_regular_file(folder_ / model));
    ASSERT_TRUE(fs::exists(folder_ / "r.json"));
    const json result = json::parse(contents(folder_ / "r.json"));
    EXPECT_TRUE(result["extended_model"].is_null());
    EXPECT_FALSE(result["verdict"].is_null());
    EXPECT_FALSE(result["tension"].is_null());
    EXPECT_NE(contents(folder_ / "p.html").find("</html>"), std::string::npos);
    EXPECT_EQ(out_.rfind("short: ", 0), 0U) << out_;
  }

  static std::string without_table(std::string text, const std::string& table) {
    const std::size_t at = text.find(table);
    EXPECT_NE(at, std::string::npos) << text;
    const std::size_t end = text.find("\n[", at);
    return text.erase(at, end == std::string::npos ? end : end - at);
  }
};

TEST_F(DiagnoseProgram, RecordingsGiveAllOutputs) {
  ASSERT_EQ(run("diagnose r --out m.toml --json r.json --report p.html --seed 3"), 0) << err_;
  const json result = json::parse(contents(folder_ / "r.json"));
  const std::string verdict = result["verdict"];
  EXPECT_TRUE(verdict == "none" || verdict == "named" || verdict == "ambiguous" ||
              verdict == "unknown")
      << verdict;
  EXPECT_EQ(out_.rfind("short: " + verdict + "\nrecordings: ", 0), 0U) << out_;
  EXPECT_EQ(result["campaign"], "short");
  EXPECT_EQ(result["seed"], 3);
  EXPECT_EQ(result["extended_model"], "m.toml");
  EXPECT_TRUE(result["lives"].is_null());
  EXPECT_NE(contents(folder_ / "p.html").find("<h1>short</h1>"), std::string::npos);
  // No motor was recorded, so that nothing of it can be seen.
  const json& invisible = result["invisible"];
  EXPECT_NE(std::find(invisible.begin(), invisible.end(), "current_offset"), invisible.end());
}

// Its plan: friction grows by 0.3 (n / 5000)^0.5, so by 0.3 / sqrt(5) = 0.134 after 1000 cycles.
TEST_F(DiagnoseProgram, NamesWhatIsHiddenInTheRecordedExample) {
  ASSERT_EQ(run("diagnose '" + (fs::path(EXAMPLES) / "recorded").string() + "' --json -"), 0)
      << err_;
  const json result = json::parse(out_);
  EXPECT_EQ(result["verdict"], "named");
  ASSERT_EQ(result["effects"].size(), 1U);
  EXPECT_EQ(result["effects"][0]["id"], "friction_wear");
  const auto holds = [&](const char* name, double truth) {
    const json& interval = result["effects"][0]["parameters"][name]["ci95"];
    return interval[0] < truth && interval[1] > truth;
  };
  EXPECT_TRUE(holds("wear_coefficient", 0.134)) << result["effects"][0];
  EXPECT_TRUE(holds("wear_exponent", 0.5)) << result["effects"][0];
}

TEST_F(DiagnoseProgram, TheModelIsReadByReplayAndPack) {
  ASSERT_EQ(run("diagnose r --out m.toml"), 0) << err_;
  EXPECT_EQ(run("replay good.csv --model m.toml"), 0) << err_;
  EXPECT_EQ(run("pack m.toml --out block.bin"), 0) << err_;
}

TEST_F(DiagnoseProgram, LivesAloneAreDiagnosed) {
  ASSERT_EQ(run("diagnose c --json r.json"), 0) << err_;
  const json result = json::parse(contents(folder_ / "r.json"));
  EXPECT_TRUE(result["tension"].is_null());
  EXPECT_FALSE(result["lives"].is_null());
  EXPECT_NE(out_.find("\nlives: "), std::string::npos) << out_;
}

TEST_F(DiagnoseProgram, JsonOnStandardOutputSendsTheSummaryElsewhere) {
  ASSERT_EQ(run("diagnose c --json -"), 0) << err_;
  EXPECT_TRUE(json::accept(out_)) << out_;
  EXPECT_EQ(err_.rfind("small: ", 0), 0U) << err_;
}

TEST_F(DiagnoseProgram, ResultsAreTheSameForAnyNumberOfThreads) {
  ASSERT_EQ(run("diagnose r --json one.json --threads 1"), 0) << err_;
  ASSERT_EQ(run("diagnose r --json three.json --threads 3"), 0) << err_;
  EXPECT_EQ(contents(folder_ / "one.json"), contents(folder_ / "three.json"));
}

TEST_F(DiagnoseProgram, FailsOnADiscrepancyWhereAsked) {
  const int status = run("diagnose c --json r.json --fail-on-discrepancy");
  const json result = json::parse(contents(folder_ / "r.json"));
  EXPECT_EQ(status, result["verdict"] == "none" ? 0 : 3);
}

TEST_F(DiagnoseProgram, WrongUsageIsStatusTwo) {
  for (const char* const arguments :
       {"diagnose", "diagnose c --without sorcery", "diagnose c --threads 0",
        "diagnose c --json a --out a", "diagnose c --json", "diagnose c d"}) {
    EXPECT_EQ(run(arguments), 2) << arguments;
    EXPECT_FALSE(err_.empty()) << arguments;
  }
}

TEST_F(DiagnoseProgram, TakesEffectsOutOfTheCatalogue) {
  ASSERT_EQ(run("diagnose c --json all.json"), 0) << err_;
  ASSERT_EQ(run("diagnose --json few.json --without second_mode,lot_frailty c"), 0) << err_;
  const auto second_modes = [this](const char* name) {
    const json result = json::parse(contents(folder_ / name));
    const json& candidates = result["candidates"];
    return std::count_if(candidates.begin(), candidates.end(), [](const json& candidate) {
      return candidate["id"].get<std::string>().find("second_mode") != std::string::npos;
    });
  };
  EXPECT_GT(second_modes("all.json"), 0);
  EXPECT_EQ(second_modes("few.json"), 0);
}

TEST_F(DiagnoseProgram, HelpHasAnExample) {
  ASSERT_EQ(run("diagnose --help"), 0);
  EXPECT_NE(out_.find("host_sim diagnose crossed --out extended.toml"), std::string::npos);
}

TEST_F(DiagnoseProgram, BadInputIsToldInOneLine) {
  expect_refusal("nowhere", "nowhere", "");
  fs::create_directories(folder_ / "n");
  write("n/campaign.toml", toml());
  expect_refusal("n", "n", "sessions.csv");
  write("r/sessions.csv", "session,specimen,file,start_cycle\ns1,a,missing.csv,0\n");
  expect_refusal("r", "r/", "missing.csv");
}

TEST_F(DiagnoseProgram, WhatWasFoundIsWrittenAlsoWhereNoModelCanHoldIt) {
  write("r/campaign.toml",
        host_sim_test::with(contents(folder_ / "r/campaign.toml"), "ipl_scale", "1e300"));
  expect_found_without_model("m.toml", "m.toml: the board cannot represent it: ");
}

TEST_F(DiagnoseProgram, WhatWasFoundIsWrittenAlsoWhereTheNominalModelLacksATable) {
  write("r/campaign.toml", without_table(contents(folder_ / "r/campaign.toml"), "[model.life]"));
  expect_found_without_model("m.toml", "r/campaign.toml: no table [model.life], which --out needs");
}

TEST_F(DiagnoseProgram, WhatWasFoundIsWrittenAlsoWhereTheModelHasNoFolder) {
  expect_found_without_model("no/such/folder/m.toml", "no/such/folder/m.toml: cannot be written: ");
}

TEST_F(DiagnoseProgram, WhatWasFoundIsWrittenAlsoWhereTheModelCannotTakeItsPlace) {
  fs::create_directories(folder_ / "taken/inside");
  expect_found_without_model("taken", "taken: cannot be written: ");
  EXPECT_TRUE(fs::is_directory(folder_ / "taken/inside"));
}

TEST_F(DiagnoseProgram, AModelAloneThatCannotBeWrittenIsToldBeforeTheWork) {
  write("r/campaign.toml", without_table(contents(folder_ / "r/campaign.toml"), "[model.life]"));
  const auto before = files();
  EXPECT_EQ(run("diagnose r --out m.toml"), 1);
  EXPECT_EQ(err_.rfind("r/campaign.toml: no table [model.life], which --out needs", 0), 0U) << err_;
  EXPECT_TRUE(out_.empty()) << out_;
  EXPECT_EQ(files(), before);
  EXPECT_EQ(run("diagnose c --json no/such/folder/r.json"), 1);
  EXPECT_EQ(err_.rfind("no/such/folder/r.json", 0), 0U) << err_;
}

TEST_F(DiagnoseProgram, RecordingsMayHaveOtherColumns) {
  ASSERT_EQ(run("diagnose r --json own.json"), 0) << err_;
  for (const auto& entry : fs::directory_iterator(folder_ / "r" / "recordings")) {
    std::string text = contents(entry.path());
    const std::size_t name = text.find("output_tension_N,");
    if (name != std::string::npos) {
      text.replace(name, 16, "\"load; cell\"");
      std::ofstream(entry.path(), std::ios::binary) << text;
    }
  }
  EXPECT_EQ(run("diagnose r --json other.json"), 1);
  EXPECT_NE(err_.find("unknown column 'load; cell'"), std::string::npos) << err_;
  ASSERT_EQ(run("diagnose r --json other.json --column '\"load; cell\"=output_tension_N'"), 0)
      << err_;
  EXPECT_EQ(contents(folder_ / "other.json"), contents(folder_ / "own.json"));
}

}  // namespace
