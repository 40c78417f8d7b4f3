#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "host_sim/life_law/life_fit.hpp"

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

struct SimulationOptions {
  std::size_t simulations = 1000;
  std::uint64_t seed = 1;
  unsigned threads = 0;  ///< 0: all cores; nothing depends on it
};

/// What lives are drawn from: any law, given by its value at each level.
struct Truth {
  std::vector<double> characteristic_life_cycles;  ///< one for each level
  double shape = 1;                                ///< Weibull
};

Truth truth_under(const LifeLaw& law, const Design& design);

/// Campaign `number` of a design. The k-th specimen of a level has the same life in every design
/// that has it, so that designs are compared on the same specimens.
life_law::LifeData simulated_campaign(const Design& design, const Truth& truth, std::uint64_t seed,
                                      std::uint64_t number);

}  // namespace host_sim::plan
