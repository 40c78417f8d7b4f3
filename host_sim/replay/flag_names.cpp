#include "host_sim/replay/flag_names.hpp"

#include <array>
#include <utility>

namespace host_sim {
namespace {

using lifemodel::Flag;

constexpr std::array kNames{
    std::pair{Flag::saturated, "saturated"},
    std::pair{Flag::overload, "overload"},
    std::pair{Flag::negative_tension, "negative_tension"},
    std::pair{Flag::gap, "gap"},
    std::pair{Flag::residue_overflow, "residue_overflow"},
    std::pair{Flag::overrun, "overrun"},
};
static_assert((1u << kNames.size()) - 1 == lifemodel::kAllFlags, "every flag has a name");

}  // namespace

const std::vector<std::string>& all_flag_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> result;
    result.reserve(kNames.size());
    for (const auto& [flag, name] : kNames) {
      result.emplace_back(name);
    }
    return result;
  }();
  return names;
}

std::vector<std::string> flag_names(lifemodel::Flags flags) {
  std::vector<std::string> result;
  for (const auto& [flag, name] : kNames) {
    if (flags.has(flag)) {
      result.emplace_back(name);
    }
  }
  return result;
}

}  // namespace host_sim
