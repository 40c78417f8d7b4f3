#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/blind/making/make.hpp"
#include "tests/blind/oracle/visibility.hpp"
#include "tests/blind/running/analyses.hpp"
#include "tests/blind/scoring/record.hpp"

namespace blind::test {
namespace {

namespace fs = std::filesystem;

nlohmann::json answer_of_program(const fs::path& campaign, std::uint64_t seed) {
  const fs::path answer = campaign.parent_path() / "answer.json";
  const std::string command =
      fmt::format("'{}' diagnose '{}' --seed {} --threads 1 --json '{}' > /dev/null", HOST_SIM,
                  campaign.string(), seed, answer.string());
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
  std::ifstream file(answer);
  return nlohmann::json::parse(file);
}

/// The program, which gets the folder's name alone, answers as the library does.
void expect_same(const Scenario& scenario, const Analysis& analysis) {
  const fs::path folder =
      fs::temp_directory_path() / fmt::format("blind-program-{}-{}", getpid(), scenario.seed);
  const fs::path campaign = folder / "campaign";
  make_blind_campaign(scenario, campaign);
  host_sim::diagnose::DiagnoseOptions options;
  options.seed = scenario.seed;
  options.threads = 2;
  const auto expected = analysis(campaign, options);
  const nlohmann::json reported = answer_of_program(campaign, scenario.seed);
  EXPECT_EQ(reported.at("verdict").get<std::string>(), verdict_name(expected.verdict));
  ASSERT_EQ(reported.at("candidates").size(), expected.candidates.size());
  for (std::size_t i = 0; i < expected.candidates.size(); ++i) {
    EXPECT_EQ(reported["candidates"][i].at("id").get<std::string>(), expected.candidates[i].id);
    EXPECT_EQ(reported["candidates"][i].at("probability").get<double>(),
              expected.candidates[i].probability);
  }
  EXPECT_EQ(reported.at("credible_set").get<std::vector<std::string>>(), expected.credible_set);
  fs::remove_all(folder);
}

TEST(BlindProgram, AnswersForRecordingsAsTheLibraryDoes) {
  expect_same(draw_recordings(kFirstScoringSeed), analysis_of_recordings());
}

TEST(BlindProgram, AnswersForLivesAsTheLibraryDoes) {
  expect_same(draw_visible_lives(kFirstScoringSeed), analysis_of_lives());
}

}  // namespace
}  // namespace blind::test
