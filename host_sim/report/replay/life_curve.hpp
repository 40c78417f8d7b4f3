#pragma once

#include <cstddef>
#include <vector>

namespace host_sim {

/// Share of broken wires over repeats of one profile; both vectors have equal length.
struct LifeCurve {
  std::vector<double> repeats;
  std::vector<double> broken;  ///< 0..1
};

/// The Weibull distribution 1 - exp(-(n D)^beta) of the life n in repeats of a profile that does
/// damage D a pass, at `points` (at least 2) evenly spaced n from 0 to where 99.9 % have broken.
/// Empty when the damage is not above 0, or a number is not finite.
/// Source: eqs. (15) and (19) of the paper with Miner's sum in place of the constant load.
[[nodiscard]] LifeCurve life_curve(double damage_per_repeat, double weibull_shape,
                                   std::size_t points = 201);

}  // namespace host_sim
