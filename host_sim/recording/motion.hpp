#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "host_sim/recording/signal.hpp"

namespace host_sim::recording {

/// The speed that a change of direction has to exceed to be one: four standard deviations of the
/// velocity's noise (at most a quarter of the top speed), or its resolution (at most a twentieth),
/// or 0.5 % of the top speed, whichever is largest. The top speed is the 99 % quantile, or the
/// largest one where that is zero.
double dead_band_m_s(std::span<const double> velocity_m_s);

/// Travel beyond which neither presliding nor slack matters any more.
inline constexpr double kSettledTravel_m = 0.005;

/// How the tendon moved, sample by sample.
struct Motion {
  std::vector<double> direction;  ///< 1 while pulling, -1 while letting go
  std::vector<double> travel_m;   ///< since the last reversal: where the velocity, taken as
                                  ///< linear between samples, was zero
  std::vector<double> reversals;  ///< since the start of the recording
  /// Whether direction and travel are known: after the first reversal of a stretch, or after
  /// kSettledTravel_m; not within the dead band around a reversal, where noise hides the sign, nor
  /// where the other sign is last seen within the dead band; nor next to a reversal, where a
  /// channel that is read a little earlier or later than the others shows the other direction.
  std::vector<bool> known;
};

/// The motion within `stretches`, in order, over which velocity was measured without a gap; outside
/// of them nothing is known.
///
/// The direction turns where the velocity exceeds `dead_band_m_s` the other way, and from the first
/// sample of that sign on; so zero keeps the last direction and noise around zero makes no
/// reversals. Before the first motion the tendon counts as pulling, though not as known. A stretch
/// that begins in the other direction than the last one ended counts one reversal.
Motion motion_of(std::span<const double> time_s, std::span<const double> velocity_m_s,
                 std::span<const Stretch> stretches, double dead_band_m_s);

/// Pieces of motion in one direction, each from kSettledTravel_m behind the reversal on: over them
/// the tendon slips along its whole sheath, and input and output tension rise and fall together.
std::vector<Stretch> slips_of(const Motion& motion);

}  // namespace host_sim::recording
