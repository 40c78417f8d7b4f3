#include "host_sim/plan/search.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace host_sim::plan {
namespace {

constexpr std::size_t kFirstOfLevel = 10;

/// Where the goal should be reached if ln of the ratio goes with 1 / sqrt(n); 0 if unknown.
std::size_t expected_total(std::size_t total, double ratio_there, double ratio) {
  constexpr double kBeyondAll = 1e9;
  const double square = std::pow(std::log(ratio_there) / std::log(ratio), 2);
  const double expected = std::ceil(static_cast<double>(total) * square);
  return expected < kBeyondAll ? static_cast<std::size_t>(expected) : 0;
}

}  // namespace

Design design_of(const Conditions& conditions, const Allocation& allocation, std::size_t total) {
  const auto counts = share_out(allocation, total);
  Design design{{}, conditions.suspend_at_cycles};
  for (std::size_t i = 0; i < counts.size(); ++i) {
    design.levels.push_back({conditions.levels_N[i], counts[i]});
  }
  return design;
}

std::size_t least_total(std::size_t low, std::size_t high, double ratio,
                        const std::function<double(std::size_t)>& ratio_at) {
  std::size_t unreached = low;
  std::size_t reached = high + 1;
  std::size_t total = std::min(low + kFirstOfLevel, high);
  for (std::size_t step = 1; reached - unreached > 1; step *= 2) {
    const double ratio_there = ratio_at(total);
    const bool here = ratio_there <= ratio;
    (here ? reached : unreached) = total;
    const std::size_t expected = expected_total(total, ratio_there, ratio);
    // A step near the last one, growing, until half of the bracket is no further.
    if (unreached > low && reached <= high && 2 * step >= reached - unreached) {
      total = (unreached + reached) / 2;
    } else if (here) {
      total = std::max(unreached + 1, std::min(expected, total - std::min(total, step)));
    } else {
      total = std::min(reached - 1, std::max(expected, total + step));
    }
  }
  return reached;
}

Found least_specimens(const Conditions& conditions, const Allocation& allocation, const Goal& goal,
                      std::size_t specimens_max, const SimulationOptions& options) {
  std::map<std::size_t, Outlook> outlooks;
  const auto ratio_at = [&](std::size_t total) {
    const Design design = design_of(conditions, allocation, total);
    return outlooks.emplace(total, look_out(conditions.law, design, goal, options))
        .first->second.ratio_at_assurance;
  };
  const std::size_t least =
      least_total(fewest_specimens(allocation) - 1, specimens_max, goal.ratio, ratio_at);
  const std::size_t total = std::min(least, specimens_max);
  return {least <= specimens_max, design_of(conditions, allocation, total), outlooks.at(total)};
}

}  // namespace host_sim::plan
