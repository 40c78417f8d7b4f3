#pragma once

#include <vector>

#include "host_sim/diagnose/diagnosis.hpp"
#include "host_sim/diagnose/tension/hypothesis.hpp"
#include "host_sim/reference/constants.hpp"

namespace host_sim::diagnose {

/// How far the catalogue goes: from the nominal model on the effect of most evidence, one after the
/// other, at most four, as long as each is kNamed probable and makes the error of more sessions
/// held out less than chance would.
///
/// Where the verdict is `unknown` the noise of samples says nothing of what is left, so that all
/// are fitted by least squares of the error in newtons.
/// @param wanted the catalogue, each effect with all its shapes
/// @param dispersion of the intervals, see dispersion_of()
/// @pre three sessions or more
std::vector<Step> steps_of(Evidence evidence, const std::vector<Wanted>& wanted, double dispersion,
                           const reference::Constants& constants);

}  // namespace host_sim::diagnose
