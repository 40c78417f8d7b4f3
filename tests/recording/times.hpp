#pragma once

#include <cstddef>
#include <vector>

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
