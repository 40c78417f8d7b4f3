#include "host_sim/life_law/log_tension_frame.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace host_sim::life_law {
namespace {

/// Loads closer together are one load that was rounded: x is zero for all.
constexpr double kNarrowest = 1e-6;
constexpr double kNoSpread = std::numeric_limits<double>::infinity();

double mean_of_failures(std::span<const LifeDatum> data) {
  double sum = 0;
  double failures = 0;
  for (const LifeDatum& datum : data) {
    if (datum.failed) {
      sum += std::log(datum.blocks.back().effective_tension_N);
      failures += 1;
    }
  }
  return failures > 0 ? sum / failures : 0;
}

}  // namespace

double LogTensionFrame::x(double effective_tension_N) const {
  return (std::log(effective_tension_N) - centre) / spread;
}

LogTensionFrame frame_of(std::span<const LifeDatum> data) {
  const double centre = mean_of_failures(data);
  double widest = 0;
  for (const LifeDatum& datum : data) {
    for (const LifeDatum::Block& block : datum.blocks) {
      widest = std::max(widest, std::abs(std::log(block.effective_tension_N) - centre));
    }
  }
  return {.centre = centre, .spread = widest > kNarrowest ? widest : kNoSpread};
}

}  // namespace host_sim::life_law
