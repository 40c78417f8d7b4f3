#pragma once

#include <cstddef>
#include <vector>

#include "host_sim/effects/tension/force_model.hpp"

namespace host_sim::diagnose {

/// Takes noise out of the output force, which would be noise of the prediction and make slopes too
/// small: by cubics over as many samples to each side, 4, 8 or 16, as foresee a sample best by
/// those around it, and not at all where two to each side foresee it better.
/// @returns the variance of its noise that is left
double smooth_output(std::vector<effects::ForceRecord>& records);

/// Keeps each so many samples that no more than twice `most` are left.
void thin(effects::ForceRecord& record, std::size_t most);

}  // namespace host_sim::diagnose
