// Scores the diagnosis of lives on campaigns that are simulated for it:
//   lives_study SPECIMENS FIRST_SEED CAMPAIGNS KIND... [--without EFFECT]
// One line a campaign, then a table. Seeds below 10,000 are for tuning.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <map>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "host_sim/diagnose/diagnosis.hpp"
#include "host_sim/statistics/parallel.hpp"
#include "tests/diagnose/lives/scenario.hpp"

namespace host_sim::test {
namespace {

using diagnose::Verdict;

std::vector<std::string> parts_of(const std::string& hidden) {
  std::istringstream in(hidden);
  std::vector<std::string> parts;
  for (std::string part; std::getline(in, part, '+');) {
    parts.push_back(part);
  }
  return parts;
}

struct Outcome {
  Scenario scenario;
  diagnose::LifeDiagnosis diagnosis;
  double seconds = 0;

  [[nodiscard]] std::string truth() const {
    if (scenario.hidden == "rig_bias" || scenario.hidden == "early_deaths") {
      return "unknown";
    }
    return scenario.hidden;
  }
  [[nodiscard]] const diagnose::Findings& findings() const { return diagnosis.findings; }
  [[nodiscard]] bool right_first() const { return findings().candidates.front().id == truth(); }
  [[nodiscard]] bool named() const { return findings().verdict == Verdict::named; }
  [[nodiscard]] bool rightly_named() const {
    return named() && std::ranges::all_of(findings().effects, [this](const auto& effect) {
             const auto parts = parts_of(truth());
             return std::ranges::find(parts, effect.id) != parts.end();
           });
  }
  [[nodiscard]] bool covered() const {
    return std::ranges::find(findings().credible_set, truth()) != findings().credible_set.end();
  }
};

constexpr std::string_view kWords[] = {"none", "named", "ambiguous", "unknown"};

void print(const Outcome& outcome) {
  std::string candidates;
  for (std::size_t i = 0; i < std::min<std::size_t>(3, outcome.findings().candidates.size()); ++i) {
    const diagnose::Candidate& candidate = outcome.findings().candidates[i];
    candidates += fmt::format(" {}:{:.3f}", candidate.id, candidate.probability);
  }
  fmt::print("{} {} {}{} {:.2f}\n", outcome.scenario.seed, outcome.scenario.hidden,
             kWords[static_cast<std::size_t>(outcome.findings().verdict)], candidates,
             outcome.seconds);
}

void print_table(std::span<const Outcome> outcomes) {
  struct Row {
    int campaigns = 0, first = 0, named = 0, rightly = 0, unknown = 0, covered = 0;
    double set = 0, seconds = 0;
  };
  std::map<std::string, Row> rows;
  for (const Outcome& outcome : outcomes) {
    for (const std::string& name : {outcome.scenario.hidden, std::string("~ all")}) {
      Row& row = rows[name];
      ++row.campaigns;
      row.first += outcome.right_first() ? 1 : 0;
      row.named += outcome.named() ? 1 : 0;
      row.rightly += outcome.rightly_named() ? 1 : 0;
      row.unknown += outcome.findings().verdict == Verdict::unknown ? 1 : 0;
      row.covered += outcome.covered() ? 1 : 0;
      row.set += static_cast<double>(outcome.findings().credible_set.size());
      row.seconds = std::max(row.seconds, outcome.seconds);
    }
  }
  fmt::print("{:<32}{:>6}{:>7}{:>7}{:>8}{:>9}{:>9}{:>6}{:>8}\n", "hidden", "n", "first", "named",
             "rightly", "unknown", "covered", "set", "max s");
  for (const auto& [name, row] : rows) {
    const double n = row.campaigns;
    fmt::print("{:<32}{:>6}{:>7.3f}{:>7.3f}{:>8}{:>9.3f}{:>9.3f}{:>6.2f}{:>8.2f}\n", name,
               row.campaigns, row.first / n, row.named / n,
               fmt::format("{}/{}", row.rightly, row.named), row.unknown / n, row.covered / n,
               row.set / n, row.seconds);
  }
}

int run(std::span<char*> arguments) {
  constexpr std::size_t kFirstKind = 4;
  if (arguments.size() <= kFirstKind) {
    fmt::print(stderr, "lives_study SPECIMENS FIRST_SEED CAMPAIGNS KIND... [--without EFFECT]\n");
    return 2;
  }
  const std::size_t specimens = std::stoul(arguments[1]);
  const std::uint64_t first = std::stoull(arguments[2]);
  const std::size_t campaigns = std::stoul(arguments[3]);
  std::vector<std::string> kinds(arguments.begin() + kFirstKind, arguments.end());
  std::vector<std::string> without;
  if (const auto flag = std::ranges::find(kinds, "--without"); flag != kinds.end()) {
    without.assign(flag + 1, kinds.end());
    kinds.erase(flag, kinds.end());
  }
  std::vector<Outcome> outcomes(kinds.size() * campaigns);
  statistics::parallel_for(outcomes.size(), [&](std::size_t i) {
    Outcome& outcome = outcomes[i];
    outcome.scenario = {specimens, kinds[i / campaigns], first + i % campaigns};
    const Campaign campaign = simulated(outcome.scenario);
    const auto begin = std::chrono::steady_clock::now();
    outcome.diagnosis = diagnose::diagnose_lives(
        campaign, {.seed = outcome.scenario.seed, .threads = 1, .without = without});
    outcome.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  });
  std::ranges::for_each(outcomes, print);
  print_table(outcomes);
  return 0;
}

}  // namespace
}  // namespace host_sim::test

int main(int argc, char** argv) {
  try {
    return host_sim::test::run(std::span(argv, static_cast<std::size_t>(argc)));
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}
