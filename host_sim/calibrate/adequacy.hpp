#pragma once

#include <span>

#include "host_sim/calibrate/calibrate.hpp"
#include "host_sim/life_law/life_fit.hpp"

namespace host_sim::calibrate {

/// Tests the fitted law against each wider form that the data can fit: free levels, curvature,
/// growing scatter. Simulated p-values from a fifth of options.bootstraps.
void test_adequacy(std::span<const life_law::LifeDatum> data, const life_law::LifeFit& fit,
                   const CalibrateOptions& options, StressLife& result);

}  // namespace host_sim::calibrate
