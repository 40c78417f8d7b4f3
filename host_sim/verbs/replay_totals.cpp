#include "host_sim/verbs/replay_totals.hpp"

#include <fmt/ostream.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "host_sim/replay/flag_names.hpp"

namespace host_sim {
namespace {

double life_used(const nlohmann::json& profile) {
  return profile["result"]["damage"]["total"].get<double>();
}

/// The first of those that use the most life; null where all were refused.
nlohmann::json most_life_used(const std::vector<batch::Answer>& answers) {
  nlohmann::json most;
  for (const batch::Answer& answer : answers) {
    if (!answer.error.empty()) {
      continue;
    }
    nlohmann::json profile = nlohmann::json::parse(answer.json);
    if (most.is_null() || life_used(profile) > life_used(most)) {
      most = std::move(profile);
    }
  }
  return most;
}

std::ptrdiff_t profiles_with(const std::string& flag, const std::vector<batch::Answer>& answers) {
  return std::count_if(answers.begin(), answers.end(), [&](const batch::Answer& answer) {
    return std::find(answer.found.begin(), answer.found.end(), flag) != answer.found.end();
  });
}

}  // namespace

void write_totals(std::ostream& out, const std::vector<batch::Answer>& answers) {
  const auto refused =
      std::count_if(answers.begin(), answers.end(),
                    [](const batch::Answer& answer) { return !answer.error.empty(); });
  fmt::print(out, "{} profiles replayed, {} refused\n", std::ssize(answers) - refused, refused);
  if (const nlohmann::json most = most_life_used(answers); !most.is_null()) {
    fmt::print(out, "  most life     {:.6g} in {}\n", life_used(most),
               most["profile"].get<std::string>());
  }
  for (const std::string& flag : all_flag_names()) {
    if (const auto count = profiles_with(flag, answers); count > 0) {
      fmt::print(out, "  flag          {} in {} of them\n", flag, count);
    }
  }
}

}  // namespace host_sim
