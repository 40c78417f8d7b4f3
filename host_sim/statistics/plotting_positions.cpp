#include <algorithm>

#include "host_sim/statistics/goodness_of_fit.hpp"
#include "host_sim/statistics/kaplan_meier.hpp"

namespace host_sim::statistics {

std::vector<PlottingPosition> plotting_positions(std::span<const Observation> sample) {
  Sample sorted(sample.begin(), sample.end());
  std::sort(sorted.begin(), sorted.end(), rises_failures_first);
  const auto size = static_cast<double>(sorted.size());
  std::vector<PlottingPosition> positions;
  double rank = 0;
  double remaining = size;
  for (const Observation& seen : sorted) {
    if (seen.failed) {
      rank += (size + 1 - rank) / (1 + remaining);
      positions.push_back({.life = seen.value, .p = (rank - 0.3) / (size + 0.4)});
    }
    --remaining;
  }
  return positions;
}

}  // namespace host_sim::statistics
