#include <utility>

#include "host_sim/recording/fault_rules.hpp"
#include "host_sim/recording/noise.hpp"

namespace host_sim::recording {

std::vector<Stretch> gaps_in(std::span<const double> time_s) {
  constexpr double kSteps = 5.5;
  std::vector<double> steps_s;
  for (std::size_t i = 1; i < time_s.size(); ++i) {
    steps_s.push_back(time_s[i] - time_s[i - 1]);
  }
  std::vector<Stretch> gaps;
  if (steps_s.empty()) {
    return gaps;
  }
  const double most_s = kSteps * quantile(steps_s, 0.5);
  for (std::size_t i = 0; i < steps_s.size(); ++i) {
    if (steps_s[i] > most_s) {
      gaps.push_back({i + 1, 1});
    }
  }
  return gaps;
}

}  // namespace host_sim::recording
