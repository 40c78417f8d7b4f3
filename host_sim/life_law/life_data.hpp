#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace host_sim::life_law {

/// One specimen as the life model sees it.
struct LifeDatum {
  struct Block {
    double effective_tension_N = 0;  ///< above 0
    double cycles = 0;               ///< above 0
  };
  static constexpr std::size_t kNoLevel = static_cast<std::size_t>(-1);

  std::vector<Block> blocks;  ///< at least one, in order; a failure is at the end of the last
  bool failed = true;
  std::size_t level = kNoLevel;  ///< number of its level from 0; specimens in blocks have none
};
using LifeData = std::vector<LifeDatum>;

/// The inverse power law with Weibull scatter: eqs. (19), (20).
struct LifeLaw {
  double scale = 0;     ///< A, in cycles times N^gamma
  double exponent = 0;  ///< gamma
  double shape = 0;     ///< beta

  /// alpha, eq. (19), in cycles.
  [[nodiscard]] double characteristic_life(double effective_tension_N) const;
  /// Eq. (21), in cycles.
  [[nodiscard]] double mean_life(double effective_tension_N) const;
  /// Cycles at which `p`, in 0 .. 1, of all specimens have failed: eq. (22).
  [[nodiscard]] double quantile(double p, double effective_tension_N) const;
};

}  // namespace host_sim::life_law
