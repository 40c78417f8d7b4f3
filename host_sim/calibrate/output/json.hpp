#pragma once

#include <string>

#include "host_sim/calibrate/result.hpp"

namespace host_sim::calibrate {

/// The result as one JSON object with the fields of the file format; what is infinite or was not
/// computed is null. Lives in cycles, intervals as [low, high].
/// @param indent spaces for each depth; negative: all on one line
std::string calibrate_json(const CalibrateResult& result, int indent = 2);

}  // namespace host_sim::calibrate
