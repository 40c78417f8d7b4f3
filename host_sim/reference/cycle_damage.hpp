#pragma once

#include <functional>

#include "host_sim/reference/constants.hpp"
#include "host_sim/reference/cycle.hpp"
#include "host_sim/reference/equations.hpp"

namespace host_sim::reference {

/// True where a turning point of the cycle reaches the ultimate tension in either direction.
bool is_overload(const Cycle& cycle, const Constants& constants);

/// Damage of one full cycle in [0, 1]: one over its life, by (11) and (19). A cycle with an
/// overload uses up one whole life, and no cycle more than that. A half cycle does half of it.
double cycle_damage(const Cycle& cycle, const Constants& constants);

/// Another effective tension in N than Gerber's, from the mean and amplitude of a cycle and that of
/// Gerber. Not negative.
using EffectiveTension = std::function<double(const MeanAmplitude& input, double gerber_N)>;

/// The same with that effective tension; an empty one is Gerber's.
double cycle_damage(const Cycle& cycle, const Constants& constants,
                    const EffectiveTension& effective);

}  // namespace host_sim::reference
