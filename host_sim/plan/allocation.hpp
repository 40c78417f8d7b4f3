#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

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

}  // namespace host_sim::plan
