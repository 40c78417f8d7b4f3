#pragma once

#include <cstddef>
#include <string>
#include <string_view>

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
