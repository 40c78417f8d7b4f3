#pragma once

#include <optional>

#include "host_sim/model/model.hpp"
#include "host_sim/reference/cycle_damage.hpp"

namespace host_sim {

/// The effective tension of one cycle by the extended life law, in double precision, in this order:
/// - mean_stress: T_Gerber^(1 - share) T_law^share with T_law = (T_m + T_a)^(1-w) T_a^w (Walker),
///   or T_a/(1 - T_m/T_u) where w is 0 (Goodman); by Walker no damage where T_m + T_a is not above
///   0;
/// - bending_fatigue: T_eff(T_a)^(1 - share) T_eff(T_a + c d_w/D)^share, T_eff the law above; at
///   least what the bend alone does about the highest tension;
/// - endurance_limit: T_eff (1 - S_e/T_eff)^share, no damage up to S_e.
/// A wider cycle never does less.
/// Empty where the model has none of them, or none with all that its equation needs.
reference::EffectiveTension extended_effective_tension(const Model& model);

/// S_e in N; nothing where nobody gave the lowest level that it is a share of.
std::optional<double> endurance_limit_N(const Extension& endurance_limit);

/// The amplitude c d_w/D in N that the bend adds; nothing where nobody gave the ratio.
std::optional<double> bending_amplitude_N(const Extension& bending_fatigue);

}  // namespace host_sim
