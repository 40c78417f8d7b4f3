#pragma once

#include <vector>

#include "host_sim/campaign/campaign.hpp"
#include "host_sim/diagnose/diagnosis.hpp"
#include "host_sim/effects/tension/force_model.hpp"
#include "host_sim/reference/constants.hpp"

namespace host_sim::diagnose {

/// Causes in a forward model in newtons: effects of the catalogue are added as long as they gain on
/// sessions that the fit never saw, those are taken out again without which it does as well, and
/// what the model leaves stands beside them.
///
/// Verdict: named where an effect is material and certain and none of the catalogue could stand in
/// its place; ambiguous where one could; else unknown where something is left, or none. What is
/// left and repeats in sessions that the fit never saw gets a correction, which has no cause.
TensionDiagnosis diagnose_forces(const std::vector<effects::ForceRecord>& records,
                                 const NominalModel& nominal, const reference::Constants& constants,
                                 const DiagnoseOptions& options);

}  // namespace host_sim::diagnose
