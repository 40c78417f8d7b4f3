#include "host_sim/verbs/fail_on.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>

namespace host_sim {
namespace {

constexpr const char* kAny = "any";

}  // namespace

CLI::Option* add_fail_on(CLI::App& verb, std::vector<std::string>& fail_on,
                         std::vector<std::string> names, const std::string& description) {
  names.emplace_back(kAny);
  // Without extra arguments: the next one may be a profile.
  return verb.add_option("--fail-on", fail_on, description)
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember(names));
}

bool fails_on(const std::vector<std::string>& fail_on, const std::vector<std::string>& found) {
  return std::any_of(found.begin(), found.end(), [&](const std::string& name) {
    return std::find(fail_on.begin(), fail_on.end(), name) != fail_on.end() ||
           std::find(fail_on.begin(), fail_on.end(), kAny) != fail_on.end();
  });
}

}  // namespace host_sim
