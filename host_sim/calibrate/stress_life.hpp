#pragma once

#include <span>

#include "host_sim/calibrate/calibrate.hpp"
#include "host_sim/life_law/life_fit.hpp"

namespace host_sim::calibrate {

/// The law with its intervals and tests from a fit without problem.
/// @param refits laws fitted to simulated campaigns, see refitted_laws()
StressLife stress_life(std::span<const life_law::LifeDatum> data, const life_law::LifeFit& fit,
                       std::span<const LifeLaw> refits, std::span<const LevelResult> levels,
                       const std::optional<CommonShape>& shape, const CalibrateOptions& options);

}  // namespace host_sim::calibrate
