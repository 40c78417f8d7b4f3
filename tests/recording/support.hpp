#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "host_sim/recording/recording.hpp"
#include "tests/io/support.hpp"

namespace host_sim::test {

inline constexpr std::string_view kRecordingHeader =
    "time_s,input_tension_N,output_tension_N,tendon_velocity_m_s\n";

/// The text of a recording of `samples` rows at 200 Hz.
inline std::string recording_text(std::size_t samples = 16) {
  std::string text(kRecordingHeader);
  for (std::size_t i = 0; i < samples; ++i) {
    text += std::to_string(0.005 * static_cast<double>(i)) + "," + std::to_string(40 + i) + "," +
            std::to_string(20 + i) + ",0.1\n";
  }
  return text;
}

}  // namespace host_sim::test

namespace host_sim::recording {

/// 0, one step, two steps, ...
inline std::vector<double> times(std::size_t samples, double step_s = 1) {
  std::vector<double> time_s(samples);
  for (std::size_t i = 0; i < samples; ++i) {
    time_s[i] = step_s * static_cast<double>(i);
  }
  return time_s;
}

}  // namespace host_sim::recording

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
void change(recording::Recording& recording, hal::files::ProfileColumnId channel, double from_s,
            double to_s, const std::function<double(double)>& value);

}  // namespace host_sim::test
