#pragma once

#include <ostream>

#include "host_sim/calibrate/result.hpp"

namespace host_sim::calibrate {

/// The result for people: levels, common shape, life law beside the paper's least squares, use
/// levels, validation, mixes, and warnings last.
void write_summary(std::ostream& out, const CalibrateResult& result);

}  // namespace host_sim::calibrate
