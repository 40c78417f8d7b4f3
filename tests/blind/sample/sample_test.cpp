#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <iostream>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "host_sim/statistics/parallel.hpp"
#include "tests/blind/generator/scenario.hpp"
#include "tests/blind/oracle/visibility.hpp"
#include "tests/blind/running/analyses.hpp"
#include "tests/blind/running/run.hpp"
#include "tests/blind/scoring/judgement.hpp"
#include "tests/blind/scoring/markdown.hpp"
#include "tests/blind/scoring/scores.hpp"

namespace blind::test {
namespace {

/// Runs campaigns of these scenarios, whose seeds no other run has at the time, on all cores and
/// prints a line of each.
/// @return records in the order of the scenarios
std::vector<Record> run_sample(const std::vector<Scenario>& scenarios, const Analysis& analysis,
                               const std::vector<std::string>& without = {}) {
  static std::mutex mutex;
  RunOptions options;
  options.folder = std::filesystem::temp_directory_path() /
                   fmt::format("blind-sample-{}-{}", getpid(), scenarios.front().seed);
  options.oracle = !without.empty();
  options.without = without;
  options.sealed = [&](std::uint64_t seed, const std::string& sha256) {
    const std::lock_guard lock(mutex);
    std::cout << fmt::format("{} sealed {}\n", seed, sha256);
  };
  std::vector<Record> records(scenarios.size());
  host_sim::statistics::parallel_for(scenarios.size(), [&](std::size_t i) {
    records[i] = run_campaign(scenarios[i], analysis, options);
    const std::lock_guard lock(mutex);
    std::cout << short_line_of(records[i]) << std::endl;
  });
  std::filesystem::remove_all(options.folder);
  return records;
}

/// The first scenarios to score with.
std::vector<Scenario> first_scenarios(Scenario (*draw)(std::uint64_t seed), std::size_t count) {
  std::vector<Scenario> scenarios;
  for (std::size_t i = 0; i < count; ++i) {
    scenarios.push_back(draw(kFirstScoringSeed + i));
  }
  return scenarios;
}

/// From `seed` on; the seed after it is left there.
Scenario next_hiding(Scenario (*draft)(std::uint64_t seed), Scenario (*draw)(std::uint64_t seed),
                     std::string_view id, std::uint64_t& seed) {
  for (;; ++seed) {
    const Scenario scenario = draft(seed);
    if (scenario.kind == CampaignKind::one && scenario.design == Design::crossed &&
        scenario.hidden.front().id == id) {
      return draw(seed++);
    }
  }
}

/// What many campaigns of other seeds have had at least.
struct OfMany {
  Proportion first;        ///< the truth is the first candidate
  Proportion named_right;  ///< of those with a name
};

/// What the answers to a sample must keep: no name where nothing is hidden, names right and the
/// truth first as often as many campaigns have had them; see Proportion::least_of().
void expect_good(const std::vector<Record>& records, const OfMany& many) {
  const Scores scores = scores_of(records);
  std::cout << summary_of(scores);
  Proportion right;
  for (const Record& record : records) {
    EXPECT_EQ(record.error, "") << short_line_of(record);
    right.add(Judgement(record).right_first());
  }
  EXPECT_EQ(scores.none_named.holds, 0U);
  EXPECT_GE(right.holds, many.first.least_of(right.of)) << text_of(right);
  EXPECT_GE(scores.named_right.holds, many.named_right.least_of(scores.named_right.of))
      << text_of(scores.named_right);
}

/// Without the effect in the catalogue nothing is named instead in its campaigns, and they are
/// unknown where an oracle sees the effect at so many standard deviations: of each effect campaigns
/// are tried until one is as plain as that.
/// @param draft gives kind, design and effects of a seed as `draw` does, sooner
void expect_unknown_without(Scenario (*draft)(std::uint64_t seed),
                            Scenario (*draw)(std::uint64_t seed), const Analysis& analysis,
                            const std::vector<std::string>& ids, double plain_sigmas) {
  host_sim::statistics::parallel_for(ids.size(), [&](std::size_t i) {
    const std::string& id = ids[i];
    std::uint64_t seed = kFirstScoringSeed;
    bool plain = false;
    while (!plain) {
      const Record record =
          run_sample({next_hiding(draft, draw, id, seed)}, analysis, {id}).front();
      const Judgement judgement(record);
      plain = judgement.visible_at(plain_sigmas);
      EXPECT_FALSE(judgement.named()) << "without " << id << ": " << short_line_of(record);
      if (plain) {
        EXPECT_TRUE(judgement.unknown()) << "without " << id << ": " << short_line_of(record);
      }
    }
  });
}

constexpr std::size_t kLifeCampaigns = 12;
constexpr std::size_t kRecordingCampaigns = 12;
constexpr std::size_t kTwoSidedCampaigns = 5;

constexpr OfMany kRightRecordings{{88, 120}, {47, 49}};
constexpr double kPlainRecordings_sigmas = 20;  ///< that must leave something unknown

TEST(BlindRecordings, Sample) {
  const auto scenarios = first_scenarios(draw_recordings, kRecordingCampaigns);
  expect_good(run_sample(scenarios, analysis_of_recordings()), kRightRecordings);
}

constexpr OfMany kRightTwoSided{{33, 60}, {19, 21}};

TEST(BlindTwoSided, Sample) {
  const auto scenarios = first_scenarios(draw_two_sided, kTwoSidedCampaigns);
  expect_good(run_sample(scenarios, analysis_of_recordings()), kRightTwoSided);
}

TEST(BlindRecordings, WithoutAnEffectItsCampaignIsUnknown) {
  expect_unknown_without(draw_recordings, draw_recordings, analysis_of_recordings(),
                         {"friction_temperature", "friction_preload", "slack"},
                         kPlainRecordings_sigmas);
}

constexpr OfMany kRightLives{{865, 1000}, {413, 414}};
constexpr double kPlainLives_sigmas = 6;  ///< that must leave something unknown

TEST(BlindLives, Sample) {
  const auto scenarios = first_scenarios(draw_visible_lives, kLifeCampaigns);
  expect_good(run_sample(scenarios, analysis_of_lives()), kRightLives);
}

TEST(BlindLives, WithoutAnEffectItsCampaignIsUnknown) {
  expect_unknown_without([](std::uint64_t seed) { return draw_lives(seed, 0); }, draw_visible_lives,
                         analysis_of_lives(), {"ageing", "lot_frailty"}, kPlainLives_sigmas);
}

}  // namespace
}  // namespace blind::test
