#pragma once

#include <span>
#include <string_view>

namespace host_sim::effects {

struct Parameter {
  std::string_view name;  ///< with its unit as suffix
  std::string_view unit;
  double minimum = 0;  ///< bounds of physics
  double maximum = 0;
  double typical = 0;     ///< magnitude of a usual effect
  bool off_line = false;  ///< no controller evaluates it; an extension may leave it out as zero
};

/// How one effect is distinguished from another.
struct Separation {
  std::string_view other;       ///< id of the effect it is confounded with
  std::string_view experiment;  ///< that breaks it, as an instruction: "heat the sheath alone"
};

/// The experiment that separates an effect from another; empty where it knows none.
inline std::string_view experiment_against(std::string_view other,
                                           std::span<const Separation> separations) {
  for (const Separation& separation : separations) {
    if (separation.other == other) {
      return separation.experiment;
    }
  }
  return {};
}

}  // namespace host_sim::effects
