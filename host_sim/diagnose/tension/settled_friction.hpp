#pragma once

#include <span>

#include "host_sim/diagnose/gram.hpp"

namespace host_sim::diagnose {

/// The friction coefficient that samples far from any reversal have, with a gain for each session:
/// what acts at reversals alone does not reach them.
/// @param nominal taken where they do not tell, or differ from it by more than a factor of four
double settled_friction(std::span<const Session> sessions, double nominal);

}  // namespace host_sim::diagnose
