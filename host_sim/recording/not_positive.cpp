#include <algorithm>

#include "host_sim/recording/fault_rules.hpp"

namespace host_sim::recording {

double least_positive(const Sensor& sensor) {
  return 4 * sensor.noise_sigma;
}

std::vector<Stretch> not_positive_in(const LiveChannel& channel) {
  constexpr std::size_t kApart = 20;
  const double least = least_positive(channel.sensor);
  std::vector<Stretch> stretches;
  for (std::size_t i = 0; i < channel.values.size(); ++i) {
    if (channel.values[i] > least) {
      continue;
    }
    if (stretches.empty() || i - stretches.back().end() >= kApart) {
      stretches.push_back({i, 0});
    }
    stretches.back().count = i + 1 - stretches.back().first;
  }
  return stretches;
}

}  // namespace host_sim::recording
