#include "host_sim/report/replay/flag_text.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace host_sim {
namespace {

using Entry = std::pair<std::string_view, FlagText>;

constexpr std::array kTexts = {
    Entry{"saturated",
          {"A value met the end of its range",
           "It was counted as the nearest value that can be held, so the true value lay beyond."}},
    Entry{"overload",
          {"The tension reached the strength of the wire",
           "A turning point was at or above the ultimate tension; it was counted as a whole life "
           "used. "
           "Take the wire as broken."}},
    Entry{"negative_tension",
          {"The tension fell below zero",
           "A wire cannot push. Look for a wrong sensor zero, current offset or direction."}},
    Entry{"gap",
          {"Samples are missing",
           "Counting went on after each gap; cycles inside a gap were not seen."}},
    Entry{"residue_overflow",
          {"More open cycles than there is room for",
           "A cycle was counted larger than it was, so the damage errs on the safe side."}},
    Entry{"overrun",
          {"Cycles were settled too late",
           "Cycles were counted larger than they were, so the damage errs on the safe side."}},
};

}  // namespace

FlagText flag_text(std::string_view flag) {
  const auto* const found = std::find_if(kTexts.begin(), kTexts.end(),
                                         [flag](const Entry& e) { return e.first == flag; });
  if (found == kTexts.end()) {
    return {flag, "The estimator reported this condition; this page has no explanation of it."};
  }
  return found->second;
}

}  // namespace host_sim
