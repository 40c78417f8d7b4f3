#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "host_sim/reference/cycle.hpp"
#include "host_sim/reference/four_point_rainflow.hpp"
#include "tests/reference/astm_rainflow.hpp"

namespace host_sim::reference::testing {

struct AstmCount {
  struct Entry {
    Cycle cycle;
    double count;
  };
  std::vector<Entry> entries;
};

inline AstmCount count_astm(std::span<const double> turning_points) {
  AstmCount result;
  const auto keep = [&](const Cycle& cycle, Extent extent) {
    result.entries.push_back({cycle, extent == Extent::kFull ? 1.0 : 0.5});
  };
  AstmRainflow rainflow;
  for (const double point : turning_points) {
    rainflow.push(point, keep);
  }
  rainflow.rest(keep);
  return result;
}

struct FourPointCount {
  std::vector<Cycle> closed;
  std::vector<double> residue;
};

inline FourPointCount count_four_point(std::span<const double> turning_points) {
  FourPointCount result;
  FourPointRainflow rainflow;
  for (const double point : turning_points) {
    rainflow.push(point, [&](const Cycle& cycle) { result.closed.push_back(cycle); });
  }
  result.residue.assign(rainflow.residue().begin(), rainflow.residue().end());
  return result;
}

/// How many half cycles lie between a low and a high turning point, whichever came first.
using HalfCycles = std::map<std::pair<double, double>, int>;

inline void add_halves(HalfCycles& halves, double a, double b, int count) {
  halves[std::minmax(a, b)] += count;
}

inline HalfCycles half_cycles(const AstmCount& count) {
  HalfCycles halves;
  for (const auto& [cycle, weight] : count.entries) {
    add_halves(halves, cycle.from_N, cycle.to_N, weight == 1.0 ? 2 : 1);
  }
  return halves;
}

inline HalfCycles half_cycles(const FourPointCount& count) {
  HalfCycles halves;
  for (const Cycle& cycle : count.closed) {
    add_halves(halves, cycle.from_N, cycle.to_N, 2);
  }
  for (std::size_t i = 1; i < count.residue.size(); ++i) {
    add_halves(halves, count.residue[i - 1], count.residue[i], 1);
  }
  return halves;
}

/// Cycles by range, a half cycle being 0.5.
using CountsByRange = std::map<double, double>;

inline CountsByRange counts_by_range(const HalfCycles& halves) {
  CountsByRange counts;
  for (const auto& [pair, count] : halves) {
    counts[pair.second - pair.first] += 0.5 * count;
  }
  return counts;
}

}  // namespace host_sim::reference::testing
