#pragma once

#include "host_sim/diagnose/lives/life_sample.hpp"
#include "host_sim/diagnose/lives/life_settings.hpp"

namespace host_sim::diagnose::lives {

/// Fully reversed tension that does the damage of a block, before any endurance limit: Gerber's,
/// or that of Walker, T_max^(1-w) T_a^w, or of Goodman, T_a/(1 - T_m/T_u); T_a with the bending,
/// and T_m where the bending goes from zero.
double damaging_N(const LifeSample& sample, const LifeSample::Block& block,
                  const LifeSettings& settings);

/// Mean of its logarithm over the last blocks of LifeSample::reference: what ln_life_at_centre is
/// for.
double centre_ln_N(const LifeSample& sample, const LifeSettings& settings);

}  // namespace host_sim::diagnose::lives
