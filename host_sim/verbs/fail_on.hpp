#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace host_sim {

/// The option `--fail-on` with `names`, several of them behind commas, or `any`.
CLI::Option* add_fail_on(CLI::App& verb, std::vector<std::string>& fail_on,
                         std::vector<std::string> names, const std::string& description);

/// Whether one of `found` is one to fail on.
bool fails_on(const std::vector<std::string>& fail_on, const std::vector<std::string>& found);

}  // namespace host_sim
