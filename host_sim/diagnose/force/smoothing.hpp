#pragma once

#include <cstddef>
#include <vector>

#include "host_sim/effects/tension/force_model.hpp"

namespace host_sim::diagnose {

/// Variance of noise.
struct OutputNoise {
  double force_N2 = 0;
  double rate_N2_s2 = 0;
};

/// Takes noise out of the output force, which would be noise of the prediction and make slopes too
/// small: by quintics over 6, 10 or 16 samples to each side, as many as foresee a sample best by
/// those around it, and not at all where two to each side foresee it better.
/// @returns the noise that is left
OutputNoise smooth_output(effects::ForceRecord& record);

/// The same of temperatures, which change more slowly than forces: 8 or 32 samples.
void smooth_temperatures(effects::ForceRecord& record);

/// Keeps each so many samples that no more than twice `most` are left.
void thin(effects::ForceRecord& record, std::size_t most);

}  // namespace host_sim::diagnose
