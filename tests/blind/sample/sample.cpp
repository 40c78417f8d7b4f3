#include "tests/blind/sample/sample.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <iostream>
#include <mutex>

#include "host_sim/statistics/parallel.hpp"
#include "tests/blind/report/markdown.hpp"
#include "tests/blind/scoring/judgement.hpp"
#include "tests/blind/scoring/scores.hpp"

namespace blind {

std::vector<Record> run_sample(const std::vector<Scenario>& scenarios, const Analysis& analysis,
                               const std::vector<std::string>& without) {
  std::mutex mutex;
  RunOptions options;
  options.folder =
      std::filesystem::temp_directory_path() / fmt::format("blind-sample-{}", getpid());
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

std::vector<Scenario> first_scenarios(Scenario (*draw)(std::uint64_t seed), std::size_t count) {
  std::vector<Scenario> scenarios;
  for (std::size_t i = 0; i < count; ++i) {
    scenarios.push_back(draw(kFirstScoringSeed + i));
  }
  return scenarios;
}

namespace {

/// From `seed` on; the seed after it is left there.
Scenario next_hiding(Scenario (*draft)(std::uint64_t seed), Scenario (*draw)(std::uint64_t seed),
                     std::string_view id, std::uint64_t& seed) {
  for (;; ++seed) {
    const Scenario scenario = draft(seed);
    if (scenario.kind == Kind::one && scenario.design == Design::crossed &&
        scenario.hidden.front().id == id) {
      return draw(seed++);
    }
  }
}

}  // namespace

void expect_good(const std::vector<Record>& records, const Proportion& right_of_many) {
  std::cout << summary_of(scores_of(records));
  Proportion right;
  for (const Record& record : records) {
    const Judgement judgement(record);
    EXPECT_EQ(record.error, "") << short_line_of(record);
    if (judgement.named()) {
      EXPECT_TRUE(judgement.named_right()) << short_line_of(record);
    }
    right.add(judgement.right_first());
  }
  EXPECT_GE(right.holds, right_of_many.least_of(right.of)) << text_of(right);
}

void expect_unknown_without(Scenario (*draft)(std::uint64_t seed),
                            Scenario (*draw)(std::uint64_t seed), const Analysis& analysis,
                            const std::vector<std::string>& ids, double plain_sigmas) {
  for (const std::string& id : ids) {
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
  }
}

}  // namespace blind
