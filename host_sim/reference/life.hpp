#pragma once

#include <span>

#include "host_sim/reference/constants.hpp"
#include "host_sim/reference/reference.hpp"

namespace host_sim::reference {

/// Marks of the life distribution: when 10, 50 and 90 % of wires have broken, and the mean.
struct LifePoints {
  double b10;
  double b50;
  double mean;
  double b90;
};

/// The marks in damage, (21) and (22).
LifePoints damage_to(double weibull_shape);

/// How many times a profile can be run until each mark, from new. All +infinity if it does no
/// damage.
/// @param damage_per_repeat >= 0
LifePoints repeats_to(double damage_per_repeat, double weibull_shape);

/// Cycles of a reading, with two half cycles to the cycle.
double equivalent_cycles(const Reading& reading);

/// The constant effective tension that does the same damage in the same number of cycles:
/// (D * A / n)^(1/gamma). Zero where nothing was counted.
double equivalent_effective_tension(const Reading& reading, const Constants& constants);

/// A part of the running time at one effective tension; the shares of a mix sum to one.
struct TensionShare {
  double effective_tension_N;
  double share;
};

/// The constant effective tension that stands for a mix whose shares are of the cycles, by Miner's
/// rule: equal average damage, so the power mean of order gamma.
double mix_by_damage(std::span<const TensionShare> mix, double ipl_exponent);

/// The same by the paper's section 4.3: equal average life, so the power mean of order -gamma.
/// It is Miner's rule only if the shares are of the damage.
double mix_by_life(std::span<const TensionShare> mix, double ipl_exponent);

}  // namespace host_sim::reference
