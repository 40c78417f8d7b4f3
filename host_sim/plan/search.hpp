#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "host_sim/plan/outlook.hpp"

namespace host_sim::plan {

/// A way to share specimens out over the levels.
struct Allocation {
  std::string name;
  std::vector<double> weights;  ///< one for each level; 0 where it is not tested
};

/// The fewest specimens of a tested level: with fewer than two failures it has no fit of its own.
inline constexpr std::size_t kFewestOfLevel = 2;

/// The allocations worth comparing for `levels_N`, rising, and a life wanted at `use_tension_N`:
///   equal              the same number at each level;
///   more at low        weights that fall evenly in ratio from 4 to 1, so 4:2:1 for three levels;
///   extremes           the lowest and the highest level, each with the weight of the other's
///                      distance from the use in ln T, which is best for the life at the use if the
///                      law is straight (Elfving's rule; Nelson 1990, section 6.2);
///   extremes + check   the same with a fifth of all at the level nearest to their middle in ln T.
/// Those that need a level between the extremes are missing with two levels.
/// @pre at least two levels
std::vector<Allocation> standard_allocations(std::span<const double> levels_N,
                                             double use_tension_N);

/// The fewest specimens that an allocation can share out.
std::size_t fewest_specimens(const Allocation& allocation);

/// Shares `total` specimens out: two for each tested level, then one at a time to the level that is
/// furthest below its weight (Webster's divisors), so that a larger total never takes a specimen
/// from a level.
/// @pre total is at least fewest_specimens(allocation)
std::vector<std::size_t> share_out(const Allocation& allocation, std::size_t total);

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
