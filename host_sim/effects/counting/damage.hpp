#pragma once

#include <cstddef>
#include <string>

#include "host_sim/recording/covariates.hpp"
#include "host_sim/reference/constants.hpp"

namespace host_sim::effects {

/// Empty where there is an input tension, else what to record for one.
std::string missing_input(const recording::Covariates& covariates);

/// The share of the damage of the input tension, counted whole and without a threshold, that is
/// lost where every `step`-th sample from the first on is counted with a hysteresis; 0 where the
/// whole does no damage.
/// @pre missing_input() is empty, step at least 1
double share_lost(const recording::Covariates& covariates, reference::Constants constants,
                  std::size_t step, double hysteresis_N);

}  // namespace host_sim::effects
