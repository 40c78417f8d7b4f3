#pragma once

#include "host_sim/diagnose/audit/audit.hpp"
#include "host_sim/diagnose/diagnosis.hpp"
#include "host_sim/diagnose/force/force_fit.hpp"

namespace host_sim::diagnose {

/// What the campaign can show and distinguish, whatever is in it.
/// @param model the best one, whose residuals are the noise
/// @param threads 0: all cores
Audit audit_of(const ForceData& data, const ForceFit& model, unsigned threads);

/// What it could not show of the catalogue, or not distinguish.
void add_invisible(const Audit& audit, Findings& findings);

}  // namespace host_sim::diagnose
