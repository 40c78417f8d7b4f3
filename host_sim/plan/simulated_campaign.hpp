#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "host_sim/plan/design.hpp"

namespace host_sim::plan {

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
