#include "tests/blind/running/run.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <sstream>

#include "hal/files/input_error.hpp"
#include "host_sim/campaign/campaign.hpp"
#include "host_sim/synth/campaign/make.hpp"
#include "tests/blind/scoring/record.hpp"
#include "tests/blind/support.hpp"

namespace blind::test {
namespace {

namespace fs = std::filesystem;
using host_sim::diagnose::DiagnoseOptions;
using host_sim::diagnose::Findings;

std::string text_of(const fs::path& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

class RunTest : public testing::Test {
 protected:
  RunTest() : folder_(fs::temp_directory_path() / ("blind_run_" + std::to_string(getpid()))) {
    fs::remove_all(folder_);
    options_.folder = folder_;
  }
  ~RunTest() override { fs::remove_all(folder_); }

  fs::path folder_;
  RunOptions options_;
};

/// Stands for the analysis: it says what it was told to say.
Analysis saying(const std::string& id) {
  return [id](const fs::path&, const DiagnoseOptions&) {
    Findings findings;
    findings.candidates = {{id, 1}};
    return findings;
  };
}

TEST_F(RunTest, TheTruthIsSealedBeforeTheAnalysisAndOutsideOfItsFolder) {
  std::string sealed;
  options_.keep = true;
  options_.sealed = [&](std::uint64_t, const std::string& sha256) { sealed = sha256; };
  std::string sealed_before;
  const auto analysis = [&](const fs::path& folder, const DiagnoseOptions&) {
    sealed_before = sealed;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      if (entry.is_regular_file()) {
        const std::string text = text_of(entry.path());
        EXPECT_EQ(text.find("wear"), std::string::npos) << entry.path();
        EXPECT_EQ(entry.path().string().find("truth"), std::string::npos);
      }
    }
    return Findings{};
  };
  const Record record = run_campaign(small_scenario(), analysis, options_);
  EXPECT_EQ(sealed_before.size(), 64U);
  EXPECT_EQ(record.truth_sha256, sealed_before);
  EXPECT_EQ(host_sim::synth::sha256(text_of(folder_ / "truths" / "7.json")), sealed_before);
}

TEST_F(RunTest, TheCampaignHasTheNominalModelAndNotTheTrueOne) {
  double friction = 0;
  const auto analysis = [&](const fs::path& folder, const DiagnoseOptions&) {
    friction = host_sim::read_campaign(folder).nominal.sheath->friction_coefficient;
    return Findings{};
  };
  run_campaign(small_scenario(), analysis, options_);
  EXPECT_NEAR(friction, 0.125, 1e-12);
}

TEST_F(RunTest, NothingStaysUnlessAskedFor) {
  run_campaign(small_scenario(), saying("none"), options_);
  EXPECT_FALSE(fs::exists(folder_ / "campaigns" / "7"));
  EXPECT_FALSE(fs::exists(folder_ / "truths" / "7.json"));
}

TEST_F(RunTest, ARefusalIsRecorded) {
  const auto analysis = [](const fs::path&, const DiagnoseOptions&) -> Findings {
    throw hal::files::InputError("sessions.csv", 1, 1, "one session", "at least two");
  };
  const Record record = run_campaign(small_scenario(), analysis, options_);
  EXPECT_NE(record.error.find("one session"), std::string::npos);
}

TEST_F(RunTest, WhatIsTakenOutOfTheCatalogueIsHandedOn) {
  std::vector<std::string> without;
  options_.without = {"friction_wear"};
  const auto analysis = [&](const fs::path&, const DiagnoseOptions& options) {
    without = options.without;
    return Findings{};
  };
  run_campaign(small_scenario(), analysis, options_);
  EXPECT_EQ(without, options_.without);
}

TEST_F(RunTest, RecordsAreGoneOnWith) {
  fs::create_directories(folder_);
  const fs::path path = folder_ / "records.jsonl";
  Record record = run_campaign(small_scenario(), saying("friction_wear"), options_);
  record.findings.credible_set = {"friction_wear"};
  record.findings.verdict = host_sim::diagnose::Verdict::named;
  { RecordsFile(path).add(record); }
  { std::ofstream(path, std::ios::app) << "{\"truth\": {\"se"; }
  RecordsFile again(path);
  ASSERT_EQ(again.records().size(), 1U);
  EXPECT_TRUE(again.has(7));
  EXPECT_FALSE(again.has(8));
  EXPECT_EQ(line_of(again.records()[0]), line_of(record));
  record.truth.seed = 8;
  again.add(record);
  EXPECT_EQ(RecordsFile(path).records().size(), 2U);
}

TEST_F(RunTest, AFileThatHoldsSomethingElseIsRefused) {
  fs::create_directories(folder_);
  const fs::path path = folder_ / "records.jsonl";
  { std::ofstream(path) << "seed,verdict\n"; }
  EXPECT_THROW(RecordsFile{path}, std::runtime_error);
}

}  // namespace
}  // namespace blind::test
