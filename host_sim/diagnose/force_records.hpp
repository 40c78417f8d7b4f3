#pragma once

#include <vector>

#include "host_sim/campaign/campaign.hpp"
#include "host_sim/effects/tension/force_record.hpp"
#include "host_sim/recording/recording.hpp"

namespace host_sim::diagnose {

/// The recordings as records in newtons. Samples that a fault touches do not count; left out are
/// recordings without both forces and a velocity, and samples of which a force was not read anew.
/// @param pulls_alone whether all forces are of one tendon
/// @throws InputError where the drive or the bend angle is missing
std::vector<effects::ForceRecord> force_records(const std::vector<recording::Recording>& recordings,
                                                const std::vector<recording::Fault>& faults,
                                                const NominalModel& nominal, bool pulls_alone);

}  // namespace host_sim::diagnose
