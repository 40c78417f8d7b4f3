#include "host_sim/plan/search.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace host_sim::plan {
namespace {

constexpr double kLowestOverHighest = 4;
constexpr double kCheckShare = 0.2;
constexpr double kLeastShare = 0.1;

Allocation equal(std::size_t levels) {
  return {"equal", std::vector<double>(levels, 1.0)};
}

Allocation more_at_low(std::size_t levels) {
  Allocation allocation{"more at low", std::vector<double>(levels)};
  for (std::size_t i = 0; i < levels; ++i) {
    const double from_highest =
        static_cast<double>(levels - 1 - i) / static_cast<double>(levels - 1);
    allocation.weights[i] = std::pow(kLowestOverHighest, from_highest);
  }
  return allocation;
}

Allocation extremes(std::span<const double> levels_N, double use_tension_N) {
  Allocation allocation{"extremes", std::vector<double>(levels_N.size(), 0.0)};
  const double from_lowest = std::abs(std::log(use_tension_N / levels_N.front()));
  const double from_highest = std::abs(std::log(use_tension_N / levels_N.back()));
  const double lowest = from_highest / (from_lowest + from_highest);
  // The other level is tested even where the use lies on one of them.
  allocation.weights.front() = std::clamp(lowest, kLeastShare, 1 - kLeastShare);
  allocation.weights.back() = 1 - allocation.weights.front();
  return allocation;
}

std::size_t middle_level(std::span<const double> levels_N) {
  const double middle = std::log(levels_N.front() * levels_N.back()) / 2;
  const auto distance = [&](double level_N) { return std::abs(std::log(level_N) - middle); };
  const auto inner = levels_N.subspan(1, levels_N.size() - 2);
  const auto nearest = std::min_element(
      inner.begin(), inner.end(), [&](double a, double b) { return distance(a) < distance(b); });
  return static_cast<std::size_t>(nearest - inner.begin()) + 1;
}

Allocation extremes_and_check(std::span<const double> levels_N, double use_tension_N) {
  Allocation allocation = extremes(levels_N, use_tension_N);
  allocation.name = "extremes + check";
  for (double& weight : allocation.weights) {
    weight *= 1 - kCheckShare;
  }
  allocation.weights[middle_level(levels_N)] = kCheckShare;
  return allocation;
}

}  // namespace

std::vector<Allocation> standard_allocations(std::span<const double> levels_N,
                                             double use_tension_N) {
  std::vector<Allocation> allocations{equal(levels_N.size()), more_at_low(levels_N.size()),
                                      extremes(levels_N, use_tension_N)};
  if (levels_N.size() > 2) {
    allocations.push_back(extremes_and_check(levels_N, use_tension_N));
  }
  return allocations;
}

std::size_t fewest_specimens(const Allocation& allocation) {
  const auto tested = std::count_if(allocation.weights.begin(), allocation.weights.end(),
                                    [](double weight) { return weight > 0; });
  return kFewestOfLevel * static_cast<std::size_t>(tested);
}

std::vector<std::size_t> share_out(const Allocation& allocation, std::size_t total) {
  std::vector<std::size_t> counts(allocation.weights.size(), 0);
  for (std::size_t i = 0; i < counts.size(); ++i) {
    counts[i] = allocation.weights[i] > 0 ? kFewestOfLevel : 0;
  }
  const auto claim = [&](std::size_t i) {
    return allocation.weights[i] / (2 * static_cast<double>(counts[i]) + 1);
  };
  for (std::size_t given = fewest_specimens(allocation); given < total; ++given) {
    std::size_t next = 0;
    for (std::size_t i = 1; i < counts.size(); ++i) {
      next = claim(i) > claim(next) ? i : next;
    }
    ++counts[next];
  }
  return counts;
}

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
