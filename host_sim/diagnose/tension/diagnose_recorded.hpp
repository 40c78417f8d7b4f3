#pragma once

#include "host_sim/diagnose/diagnosis.hpp"
#include "host_sim/diagnose/sessions.hpp"

namespace host_sim::diagnose {

/// All steps on recordings that were read.
/// @throws InputError where there is something to diagnose and no nominal sheath
TensionDiagnosis diagnose_recorded(const Campaign& campaign, const RecordedSessions& recorded,
                                   const DiagnoseOptions& options);

}  // namespace host_sim::diagnose
