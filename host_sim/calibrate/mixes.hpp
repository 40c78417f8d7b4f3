#pragma once

#include <vector>

#include "host_sim/calibrate/result.hpp"

namespace host_sim::calibrate {

/// Loads that vary, with the constant loads that do the same under `law`: uses with several parts,
/// then specimens in blocks.
std::vector<MixResult> mixes(const Campaign& campaign, const LifeLaw& law);

/// By equal average damage and by equal average life (section 4.3 of the paper).
MixResult mix(std::string name, std::vector<MixResult::Part> parts, double ipl_exponent);

}  // namespace host_sim::calibrate
