#pragma once

#include <span>

#include "host_sim/synth/tension/part.hpp"

namespace host_sim::synth {

/// The effects of the catalogue that a rig may have, in order of its table.
std::span<const TensionKind> tension_kinds();

/// Departures that the catalogue does not have.
std::span<const TensionKind> outside_tension_kinds();

}  // namespace host_sim::synth
