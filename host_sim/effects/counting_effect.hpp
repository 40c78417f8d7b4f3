#pragma once

#include <string_view>

namespace host_sim::effects {

/// One effect on what is counted of a tension. It changes no tension, so that no fit can show it.
struct CountingEffect {
  std::string_view id;
  std::string_view term;
};

inline constexpr CountingEffect kCountingEffects[] = {
    {"small_cycles", "cycles below the threshold of the counter"},
    {"undersampling", "peaks lost between samples"},
};

}  // namespace host_sim::effects
