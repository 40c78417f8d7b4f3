#pragma once

#include <span>

#include "host_sim/campaign/campaign_files.hpp"

namespace host_sim {

/// Gives specimens whose life was dropped as one of the lowest or highest of their level the cycles
/// that are known of it: those of the lowest or highest life that was kept.
/// @pre each specimen has its blocks
/// @throws InputError where the level has no life that was kept, or where others of it leave open
///   which lives were the lowest or highest: found broken between inspections; suspended, for the
///   highest; suspended before the lowest life that was kept, for the lowest
void place_trimmed(std::span<SpecimenRow> rows);

}  // namespace host_sim
