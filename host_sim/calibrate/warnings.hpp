#pragma once

#include <span>

#include "host_sim/calibrate/result.hpp"

namespace host_sim::calibrate {

/// Adds to the warnings what a reader of the result has to know before its numbers: levels without
/// a fit, levels left out, tests that reject, extrapolation, intervals without an end.
void add_warnings(const Campaign& campaign, std::span<const Level> sources,
                  CalibrateResult& result);

}  // namespace host_sim::calibrate
