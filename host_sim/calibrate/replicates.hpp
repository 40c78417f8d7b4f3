#pragma once

#include <span>
#include <vector>

#include "host_sim/calibrate/calibrate.hpp"
#include "host_sim/life_law/life_data.hpp"

namespace host_sim::calibrate {

/// The law fitted again to each of `options.bootstraps` campaigns simulated from `law` with the
/// loads and suspensions of `data`. A replicate that has no fit keeps a shape of 0.
std::vector<LifeLaw> refitted_laws(std::span<const life_law::LifeDatum> data, const LifeLaw& law,
                                   const CalibrateOptions& options);

}  // namespace host_sim::calibrate
