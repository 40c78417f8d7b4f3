#pragma once

#include <string>
#include <vector>

#include "host_sim/recording/recording.hpp"

namespace host_sim::recording {

/// All faults of one kind in one channel, over all sessions.
struct FaultSummary {
  ProfileColumnId channel = kTime;
  Fault::Kind kind = Fault::Kind::constant;
  std::size_t sessions = 0;  ///< that have it
  std::size_t faults = 0;
  std::size_t samples = 0;  ///< that they touch
  std::string words;        ///< those of the first fault, and how many more there are
};

/// @param faults of faults_of()
/// @returns by channel, then by kind
std::vector<FaultSummary> summary_of(const std::vector<Fault>& faults);

}  // namespace host_sim::recording
