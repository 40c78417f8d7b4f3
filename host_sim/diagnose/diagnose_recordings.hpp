#pragma once

#include <vector>

#include "host_sim/campaign/campaign.hpp"
#include "host_sim/diagnose/diagnosis.hpp"
#include "host_sim/recording/recording.hpp"

namespace host_sim::diagnose {

/// What recordings that were read show: causes by the forward model in newtons, and what the
/// campaign could not show of the catalogue, or not distinguish, whatever is in it.
/// @param faults of these recordings
/// @throws InputError where there is something to diagnose and no nominal sheath
TensionDiagnosis diagnose_recordings(const Campaign& campaign,
                                     const std::vector<recording::Recording>& recordings,
                                     const std::vector<recording::Fault>& faults,
                                     const DiagnoseOptions& options);

}  // namespace host_sim::diagnose
