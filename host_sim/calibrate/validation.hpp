#pragma once

#include <cstddef>
#include <span>

#include "host_sim/calibrate/calibrate.hpp"
#include "host_sim/life_law/life_fit.hpp"

namespace host_sim::calibrate {

/// Miner's sum of a specimen under a law.
double damage(const life_law::LifeDatum& datum, const life_law::LifeLaw& law);

/// Mean damage at failure: of the failures where all lives are known, else by maximum likelihood
/// under the shape of the law. NaN where the data do not hold it from both sides.
double mean_damage(std::span<const life_law::LifeDatum> data, const life_law::LifeLaw& law);

/// Compares validation specimens of one load, or of loads in blocks, with the law. Each replicate
/// draws the specimens from the law and judges them by a law fitted to a simulated campaign, so
/// that p holds the uncertainty of the fit.
/// @param index  number of the comparison, for its random numbers
/// @param refits see refitted_laws()
/// Nothing where no specimen failed.
std::optional<ValidationResult> validate(std::span<const life_law::LifeDatum> specimens,
                                         const LifeLaw& law, std::span<const LifeLaw> refits,
                                         std::size_t index, const CalibrateOptions& options);

}  // namespace host_sim::calibrate
