#pragma once

#include <span>
#include <vector>

#include "host_sim/calibrate/calibrate.hpp"
#include "host_sim/life_law/life_fit.hpp"

namespace host_sim::calibrate {

/// The law fitted again to each of `options.bootstraps` campaigns simulated from `law` with the
/// loads and suspensions of `data`. A replicate that has no fit keeps a shape of 0.
std::vector<LifeLaw> refitted_laws(std::span<const life_law::LifeDatum> data, const LifeLaw& law,
                                   const CalibrateOptions& options);

/// Tests the fitted law against each wider form that the data can fit: free levels, curvature,
/// growing scatter. Simulated p-values from a fifth of options.bootstraps.
void test_adequacy(std::span<const life_law::LifeDatum> data, const life_law::LifeFit& fit,
                   const CalibrateOptions& options, StressLife& result);

/// The law with its intervals and tests from a fit without problem.
/// @param refits laws fitted to simulated campaigns, see refitted_laws()
/// @param use_N effective tensions of the use levels, which the band reaches
StressLife stress_life(std::span<const life_law::LifeDatum> data, const life_law::LifeFit& fit,
                       std::span<const LifeLaw> refits, std::span<const LevelResult> levels,
                       const std::optional<CommonShape>& shape, std::span<const double> use_N,
                       const CalibrateOptions& options);

}  // namespace host_sim::calibrate
