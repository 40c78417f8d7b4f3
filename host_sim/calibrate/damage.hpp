#pragma once

#include <cstddef>
#include <span>

#include "host_sim/life_law/life_data.hpp"

namespace host_sim::calibrate {

/// Miner's sum of a specimen under a law.
double damage(const life_law::LifeDatum& datum, const life_law::LifeLaw& law);

/// Mean damage at failure: of the failures where all failed, else by maximum likelihood under the
/// shape of the law. NaN where none failed.
double mean_damage(std::span<const life_law::LifeDatum> data, const life_law::LifeLaw& law);

}  // namespace host_sim::calibrate
