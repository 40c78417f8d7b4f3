#pragma once

#include "host_sim/diagnose/lives/life_sample.hpp"
#include "host_sim/diagnose/lives/life_settings.hpp"

namespace host_sim::diagnose::lives {

/// Probability that a specimen of an unknown lot survives the cycles that it has.
double survival(const LifeSample& sample, const LifeSample::Specimen& specimen,
                const LifeSettings& settings);

/// Cycles, in the last block of `specimen`, at which `p` of all like it have failed.
double quantile_cycles(const LifeSample& sample, LifeSample::Specimen specimen,
                       const LifeSettings& settings, double p);

}  // namespace host_sim::diagnose::lives
