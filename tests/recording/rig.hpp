#pragma once

#include <functional>

#include "host_sim/recording/recording.hpp"

namespace host_sim::test {

/// A tendon in a sheath of 0.6 = mu phi, drawn to and fro at constant full slip for 20 s at 200 Hz.
struct Rig {
  double frequency_Hz = 0.5;
  double noise = 0;       ///< of every sensor, as a share of the range of its values
  double resolution = 0;  ///< of every sensor, as a share of the range of its values
  bool holds = false;     ///< stands still at both ends, for a tenth of the cycle each
  std::uint64_t seed = 1;
};

/// Input tension, motor current, output tension, velocity, motor angle, both temperatures and the
/// bend angle.
recording::Recording recording_of(const Rig& rig);

/// Changes the values of a channel within [from, to) seconds.
void change(recording::Recording& recording, ProfileColumnId channel, double from_s, double to_s,
            const std::function<double(double)>& value);

}  // namespace host_sim::test
