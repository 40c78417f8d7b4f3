// Writes what the diagnosis of lives is calibrated with:
//   lives_evidence FOLDER FIRST_SEED CAMPAIGNS
// FOLDER is one that `blind_make --lives --out FOLDER` wrote. One line for each explanation:
//   seed truth specimens id effects outside log_evidence log_likelihood
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "host_sim/campaign/campaign.hpp"
#include "host_sim/diagnose/lives/audit.hpp"
#include "host_sim/diagnose/lives/hypotheses.hpp"
#include "host_sim/statistics/parallel.hpp"

namespace host_sim::test {
namespace {

using namespace host_sim::diagnose::lives;

std::string truth_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  const nlohmann::json truth = nlohmann::json::parse(file);
  std::set<std::string> ids;
  for (const nlohmann::json& hidden : truth.at("hidden")) {
    if (hidden.at("outside").get<bool>()) {
      return "unknown";
    }
    ids.insert(hidden.at("id").get<std::string>());
  }
  return ids.empty() ? "none" : fmt::format("{}", fmt::join(ids, "+"));
}

std::string lines_of(const std::filesystem::path& folder, const std::string& seed) {
  const std::string truth = truth_of(folder / "truths" / (seed + ".json"));
  const Campaign campaign = read_campaign(folder / "campaigns" / seed);
  const LifeSample sample = sample_of(campaign, Campaign::Role::fit);
  const LifeAudit audit = audit_lives(sample, campaign.specimens, fit_nominal(sample));
  std::string lines;
  for (const Hypothesis& hypothesis : weigh(sample, audit.visible(), calibration(), 1)) {
    lines +=
        fmt::format("{} {} {} {} {} {} {:.4f} {:.4f}\n", seed, truth, sample.size(),
                    hypothesis.outside ? hypothesis.effects.front() : hypothesis.id(),
                    hypothesis.outside ? 0 : hypothesis.effects.size(), hypothesis.outside ? 1 : 0,
                    hypothesis.log_evidence, hypothesis.best().fit.log_likelihood);
  }
  return lines;
}

void run(std::span<char*> arguments) {
  const std::filesystem::path folder = arguments[1];
  const std::size_t first = std::stoul(arguments[2]);
  std::vector<std::string> lines(std::stoul(arguments[3]));
  statistics::parallel_for(
      lines.size(), [&](std::size_t i) { lines[i] = lines_of(folder, std::to_string(first + i)); });
  for (const std::string& some : lines) {
    fmt::print("{}", some);
  }
}

}  // namespace
}  // namespace host_sim::test

int main(int argc, char** argv) {
  constexpr int kArguments = 4;
  if (argc != kArguments) {
    fmt::print(stderr, "lives_evidence FOLDER FIRST_SEED CAMPAIGNS\n");
    return 2;
  }
  try {
    host_sim::test::run(std::span(argv, static_cast<std::size_t>(argc)));
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
  return 0;
}
