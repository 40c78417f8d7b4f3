#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "host_sim/life_law/life_data.hpp"

namespace host_sim::plan {

using life_law::LifeLaw;

/// How many specimens a life test would have at one load.
struct PlannedLevel {
  double effective_tension_N = 0;  ///< above 0
  std::size_t specimens = 0;       ///< 0 where the level is not tested
};

/// A life test that has not been made.
struct Design {
  std::vector<PlannedLevel> levels;  ///< rising tension
  double suspend_at_cycles =
      std::numeric_limits<double>::infinity();  ///< every specimen that lasts so long

  [[nodiscard]] std::size_t specimens() const;
  /// Levels with specimens.
  [[nodiscard]] std::size_t tested_levels() const;
};

/// Failures that a level is expected to have before its specimens are suspended.
double expected_failures(const PlannedLevel& level, double suspend_at_cycles, const LifeLaw& law);

/// Cycles that all specimens of a level together are expected to run.
double expected_cycles(const PlannedLevel& level, double suspend_at_cycles, const LifeLaw& law);

}  // namespace host_sim::plan
