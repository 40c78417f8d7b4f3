#pragma once

#include <span>
#include <vector>

#include "host_sim/campaign/campaign.hpp"
#include "host_sim/diagnose/diagnosis.hpp"
#include "host_sim/diagnose/force/force_fit.hpp"

/// What is likely to be wrong with recordings or with the nominal model as they were written down:
/// signs, units, ends and channels exchanged or shifted, a session unlike the others. No effect of
/// the catalogue makes friction drive the motion, or a force 1,000 times as large.
namespace host_sim::diagnose {

/// Without any effect, by what gain and friction suit each session alone.
std::vector<Doubt> doubts_of(std::span<const effects::ForceRecord> records,
                             const NominalModel& nominal);

/// Records without sessions that a doubt spoils. Where too few were left to name anything, or less
/// than half, all stay, and such doubts spoil nothing.
std::vector<effects::ForceRecord> sound_of(const std::vector<effects::ForceRecord>& records,
                                           std::vector<Doubt>& doubts);

/// By what a model leaves: gain and friction far off the nominal ones, sessions unlike the others,
/// and where much is left, a channel that would fit if it had come sooner.
/// @param records that the data are of, with all samples
/// @param much whether much is left
std::vector<Doubt> doubts_beside(const ForceData& data,
                                 std::span<const effects::ForceRecord> records,
                                 const ForceFit& model, const NominalModel& nominal, bool much);

}  // namespace host_sim::diagnose
