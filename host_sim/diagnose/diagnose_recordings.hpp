#pragma once

#include "host_sim/diagnose/diagnosis.hpp"
#include "host_sim/diagnose/sessions.hpp"

namespace host_sim::diagnose {

/// What recordings that were read show: causes by the forward model in newtons, and of one tendon
/// what the campaign could not show of the catalogue, or not distinguish, whatever is in it.
/// @throws InputError where there is something to diagnose and no nominal sheath
TensionDiagnosis diagnose_recordings(const Campaign& campaign, const RecordedSessions& recorded,
                                     const DiagnoseOptions& options);

}  // namespace host_sim::diagnose
