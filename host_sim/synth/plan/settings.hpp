#pragma once

#include <cstdint>
#include <vector>

#include "host_sim/synth/plan/plan.hpp"

namespace host_sim::synth {

/// The sessions of a plan in the order in which they are run. A crossed design runs through the
/// last of its lists first; repeats follow each other as a whole. Only a balanced one depends on
/// the seed.
std::vector<Setting> settings_of(const RecordingPlan& plan, std::uint64_t seed);

/// How many they are; for a crossed design at most kMostSessions + 1.
std::size_t session_count(const RecordingPlan& plan);

inline constexpr std::size_t kMostSessions = 10'000;

}  // namespace host_sim::synth
