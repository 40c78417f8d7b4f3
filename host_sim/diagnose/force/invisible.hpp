#pragma once

#include "host_sim/diagnose/diagnosis.hpp"
#include "host_sim/diagnose/force/force_fit.hpp"

namespace host_sim::diagnose {

/// What the campaign could not show of the catalogue, or not distinguish, whatever is in it.
/// @param model the best one, whose residuals are the noise
/// @param threads 0: all cores
void add_invisible(const ForceData& data, const ForceFit& model, unsigned threads,
                   Findings& findings);

}  // namespace host_sim::diagnose
