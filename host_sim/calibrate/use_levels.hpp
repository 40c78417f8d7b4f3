#pragma once

#include <span>
#include <string>
#include <vector>

#include "host_sim/calibrate/calibrate.hpp"
#include "host_sim/calibrate/result.hpp"
#include "host_sim/life_law/life_fit.hpp"

namespace host_sim::calibrate {

/// The life at a constant effective tension, with intervals.
/// @param index  number of the use level, for its random numbers
/// @param refits see refitted_laws()
UseLevel use_level(std::string name, double effective_tension_N,
                   std::span<const life_law::LifeDatum> data, const life_law::LifeFit& fit,
                   std::span<const LifeLaw> refits, std::size_t index,
                   const CalibrateOptions& options);

/// Loads that vary, with the constant loads that do the same under `law`: uses with several parts,
/// then specimens in blocks.
std::vector<MixResult> mixes(const Campaign& campaign, const LifeLaw& law);

/// By equal average damage and by equal average life (section 4.3 of the paper).
MixResult mix(std::string name, std::vector<MixResult::Part> parts, double ipl_exponent);

}  // namespace host_sim::calibrate
