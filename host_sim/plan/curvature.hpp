#pragma once

#include <optional>

#include "host_sim/plan/simulated_campaign.hpp"

namespace host_sim::plan {

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
