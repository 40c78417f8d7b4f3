#pragma once

#include <cstddef>
#include <span>

#include "host_sim/reference/constants.hpp"

namespace host_sim::effects {

/// Total damage of every `step`-th sample from the first on.
/// @pre step at least 1
double damage_of(std::span<const double> tension_N, std::size_t step,
                 const reference::Constants& constants);

/// The share of `full` that `left` lacks; 0 where `full` is 0.
double share_lost(double full, double left);

}  // namespace host_sim::effects
