#pragma once

#include <span>

#include "host_sim/calibrate/calibrate.hpp"

namespace host_sim::calibrate {

/// Finds the common shape of the levels of role fit, tests it, and marks as left out the level that
/// breaks it: where one shape is rejected at 5 % (simulated) and one level differs from the others
/// at 5 % after correction for having looked at each. Repeats while at least three levels are left.
/// Nothing with fewer than two levels that have a fit of their own.
std::optional<CommonShape> common_shape(std::span<LevelResult> levels,
                                        const CalibrateOptions& options);

}  // namespace host_sim::calibrate
