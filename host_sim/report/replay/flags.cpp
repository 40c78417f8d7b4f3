#include "host_sim/report/replay/flags.hpp"

#include <algorithm>
#include <array>

namespace host_sim {
namespace {

struct KnownFlag {
  lifemodel::Flag flag;
  std::string_view name;
  FlagText text;
};

constexpr std::array kFlags = {
    KnownFlag{
        lifemodel::Flag::saturated,
        "saturated",
        {"A value met the end of its range",
         "It was counted as the nearest value that can be held, so the true value lay beyond."}},
    KnownFlag{lifemodel::Flag::overload,
              "overload",
              {"The tension reached the strength of the wire",
               "A sample was at or above the ultimate tension; it was counted as a whole life "
               "used. "
               "Take the wire as broken."}},
    KnownFlag{lifemodel::Flag::negative_tension,
              "negative_tension",
              {"The tension fell below zero",
               "A wire cannot push. Look for a wrong sensor zero, current offset or direction."}},
    KnownFlag{lifemodel::Flag::gap,
              "gap",
              {"Samples are missing",
               "Counting continued after each gap; cycles inside a gap were not seen."}},
    KnownFlag{lifemodel::Flag::residue_overflow,
              "residue_overflow",
              {"More open cycles than there is room for",
               "A cycle was counted larger than it was, so the damage errs on the safe side."}},
    KnownFlag{lifemodel::Flag::overrun,
              "overrun",
              {"Cycles were settled too late",
               "Cycles were counted larger than they were, so the damage errs on the safe side."}},
};
static_assert((1u << kFlags.size()) - 1 == lifemodel::kAllFlags, "every flag has a name");

}  // namespace

const std::vector<std::string>& all_flag_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> result;
    result.reserve(kFlags.size());
    for (const KnownFlag& flag : kFlags) {
      result.emplace_back(flag.name);
    }
    return result;
  }();
  return names;
}

std::vector<std::string> flag_names(lifemodel::Flags flags) {
  std::vector<std::string> result;
  for (const KnownFlag& flag : kFlags) {
    if (flags.has(flag.flag)) {
      result.emplace_back(flag.name);
    }
  }
  return result;
}

FlagText flag_text(std::string_view name) {
  const auto* const found = std::ranges::find(kFlags, name, &KnownFlag::name);
  if (found == kFlags.end()) {
    return {name, "The estimator reported this condition; this page has no explanation of it."};
  }
  return found->text;
}

}  // namespace host_sim
