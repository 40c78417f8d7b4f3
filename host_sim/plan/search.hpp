#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "host_sim/plan/allocation.hpp"
#include "host_sim/plan/outlook.hpp"

namespace host_sim::plan {

/// The frame of the designs that are compared.
struct Conditions {
  LifeLaw law;
  std::vector<double> levels_N;  ///< rising, distinct
  double suspend_at_cycles = std::numeric_limits<double>::infinity();
};

/// The design that shares `total` specimens out over the levels.
Design design_of(const Conditions& conditions, const Allocation& allocation, std::size_t total);

/// The least design of an allocation that reaches a goal, or the largest that does not.
struct Found {
  bool reached = false;
  Design design;
  Outlook outlook;
};

/// Searches the least total number of specimens, at most `specimens_max`, by simulation: designs
/// grow until the goal is reached, then the bracket is halved.
/// @pre specimens_max is at least fewest_specimens(allocation)
/// @throws Interruption
Found least_specimens(const Conditions& conditions, const Allocation& allocation, const Goal& goal,
                      std::size_t specimens_max, const SimulationOptions& options);

/// The least of `low` + 1 .. `high` for which `ratio_at` is at most `ratio`, which must hold for
/// all above if it holds for one; `high` + 1 if there is none. The width of an interval goes with
/// 1 / sqrt(n), which is where it looks first.
std::size_t least_total(std::size_t low, std::size_t high, double ratio,
                        const std::function<double(std::size_t)>& ratio_at);

}  // namespace host_sim::plan
