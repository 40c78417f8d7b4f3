#pragma once

#include <filesystem>
#include <string>

#include "host_sim/synth/campaign/make.hpp"

namespace host_sim::synth {

/// Simulates the sessions of a plan and writes sessions.csv and the recordings.
/// @pre plan.recordings
/// @throws OutputError, Interruption
Truth write_sessions(const SynthPlan& plan, const MakeOptions& options,
                     const std::filesystem::path& folder);

/// What the sensors say in one session: noise and all.
/// @throws InputError where a value runs out of the range of its channel
Channels session_channels(const SynthPlan& plan, const Setting& setting,
                          const SessionScatter& scatter, std::uint64_t seed);

/// What is drawn for a session.
SessionScatter session_scatter(const SynthPlan& plan, std::uint64_t seed, std::size_t session);

/// A recording as CSV, with the channels wanted that there are.
std::string recording_text(const std::vector<hal::files::ProfileColumnId>& wanted,
                           const Channels& channels);

}  // namespace host_sim::synth
