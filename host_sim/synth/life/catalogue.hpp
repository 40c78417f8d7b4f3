#pragma once

#include <span>

#include "host_sim/synth/life/part.hpp"

namespace host_sim::synth {

/// The effects of the catalogue that lives may show, in order of its table.
std::span<const LifeKind> life_kinds();

/// Departures that the catalogue does not have.
std::span<const LifeKind> outside_life_kinds();

}  // namespace host_sim::synth
