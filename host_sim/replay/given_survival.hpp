#pragma once

#include <optional>
#include <string>

#include "host_sim/model/model.hpp"
#include "host_sim/report/replay/report_data.hpp"

namespace host_sim {

/// A horizon as the command line has it: repeats of the profile, or hours of it.
struct Horizon {
  double value = 0;       ///< above 0
  bool in_hours = false;  ///< else repeats
  std::string text;       ///< as it was given: "8h", "200"
};

/// "8h" or "200"; nothing for what is not above 0 or no number.
std::optional<Horizon> horizon_from(const std::string& text);

/// What is asked about a wire that is whole now.
struct AskedOfSurvivor {
  double used = 0;  ///< damage before the profile, 1 is the characteristic life
  std::optional<Horizon> horizon;
};

/// Life given survival, conditional.hpp's equations in double precision.
/// @param damage of one repeat; where it is 0 all repeats are infinite
/// @param duration_s of one repeat, for a horizon in hours
/// @param effective_tension_N that the profile is equivalent to, for the interval of the life there
///
/// Intervals take life at that tension, exponent and shape as independent and add their effects on
/// the logarithm as the root of the sum of squares, each end on its own. Life that is shorter makes
/// `used` larger as well as each repeat.
GivenSurvival given_survival(const AskedOfSurvivor& asked, double damage, double duration_s,
                             double effective_tension_N, const Model::Life& life);

/// The risk over repeats, with the intervals of given_survival(): as far as 99 % risk, and further,
/// up to three times as far, where a new wire reaches its B90 there. Empty where the damage is 0.
BreakCurve break_curve(double used, double damage, double effective_tension_N,
                       const Model::Life& life);

}  // namespace host_sim
