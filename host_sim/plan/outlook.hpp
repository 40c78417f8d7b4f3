#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "host_sim/plan/design.hpp"

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

/// A bend of the power law: ln alpha gets - ln(factor) (x - l) (x - h) / ((u - l) (u - h)), with
/// x = ln T_eff, l and h those of the lowest and the highest tested level, u that of the use. The
/// life at both extreme levels stays, and the life at the use is `factor` times less than the
/// straight law through them says. Where the use lies between the levels, u is their middle.
struct Curvature {
  double use_tension_N = 0;
  double factor = 2;  ///< above 0, not 1
};

/// Share of campaigns of a design that show the curvature: whose likelihood-ratio test of a curved
/// law against a straight one exceeds what 5 % of campaigns without curvature exceed. None for
/// fewer than three tested levels, which any curvature fits.
/// @throws Interruption
std::optional<double> power_to_see(const Curvature& curvature, const LifeLaw& law,
                                   const Design& design, const SimulationOptions& options);

/// The same campaigns' truth: characteristic lives under the bent law.
/// @pre at least two tested levels
Truth truth_under(const LifeLaw& law, const Curvature& curvature, const Design& design);

}  // namespace host_sim::plan
