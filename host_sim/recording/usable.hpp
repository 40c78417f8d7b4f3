#pragma once

#include <vector>

#include "host_sim/recording/recording.hpp"
#include "host_sim/recording/stretch.hpp"

namespace host_sim::recording {

/// What the faults of its session leave of a recording. A constant channel counts as not recorded;
/// any other fault takes its samples.
struct Usable {
  Channels channels;            ///< as recorded, empty where the channel is left out
  std::vector<bool> touched;    ///< samples that a fault takes
  std::vector<Stretch> motion;  ///< over which velocity was measured without a gap
};

/// @param faults of any sessions; those of others do not matter
Usable usable_part(const Recording& recording, const std::vector<Fault>& faults);

}  // namespace host_sim::recording
