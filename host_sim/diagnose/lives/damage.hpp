#pragma once

#include <span>

namespace host_sim::diagnose::lives {

/// Damage D that a specimen has when its life is a unit of strength, in logarithms: it fails as its
/// strength w, Weibull distributed with scale 1, is D.
struct Damage {
  double ln = 0;       ///< ln D
  double ln_rate = 0;  ///< ln of dD/dn in the last block
};

struct LoadedBlock {
  double ln_life = 0;  ///< ln alpha; infinite where the load does no damage
  double cycles = 0;
};

/// Miner's sum where `sequence_exponent` is 0. Else by Manson and Halford: a share x of life in one
/// block counts as x^((N_before/N)^q) in the next, and D is the strength at which it reaches 1.
/// @pre at least one block
Damage damage_of(std::span<const LoadedBlock> blocks, double sequence_exponent);

}  // namespace host_sim::diagnose::lives
