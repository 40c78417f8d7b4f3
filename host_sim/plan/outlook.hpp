#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "host_sim/plan/simulated_campaign.hpp"

namespace host_sim::plan {

inline constexpr double kB10 = 0.1;

/// What is wanted of a life test: high / low of the 95 % profile-likelihood interval of B10 at a
/// use level.
struct Goal {
  double use_tension_N = 0;  ///< effective tension, above 0
  double ratio =
      std::numeric_limits<double>::infinity();  ///< high / low at most, above 1; infinite: any
  double assurance = 0.8;                       ///< in this share of campaigns at least, in 0 .. 1
};

/// What a design would give.
struct Outlook {
  struct Level {
    double effective_tension_N = 0;
    std::size_t specimens = 0;
    double failures = 0;        ///< expected
    double cycles = 0;          ///< expected, of all specimens together
    double longest_cycles = 0;  ///< mean over the simulated campaigns of the longest run
  };
  std::vector<Level> levels;
  double ratio_median = 0;
  double ratio_at_assurance = 0;  ///< that share of campaigns is at or below it; may be infinite
  double share_within = 0;        ///< of campaigns whose interval is as narrow as wanted
  double coverage = 0;            ///< of campaigns whose interval holds the true B10
  double no_interval = 0;         ///< share of campaigns that cannot be fitted or bound B10

  [[nodiscard]] std::size_t specimens() const;
  [[nodiscard]] double failures() const;
  [[nodiscard]] double cycles() const;
  [[nodiscard]] bool reaches(const Goal& goal) const { return ratio_at_assurance <= goal.ratio; }
};

/// Simulates campaigns of a design under `law`, fits each, and takes its interval.
/// @throws Interruption
Outlook look_out(const LifeLaw& law, const Design& design, const Goal& goal,
                 const SimulationOptions& options);

}  // namespace host_sim::plan
