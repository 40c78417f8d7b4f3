#pragma once

#include <span>
#include <vector>

namespace host_sim::recording {

/// The q-quantile of `values` (at least one), for q in [0, 1], without interpolation.
double quantile(std::vector<double> values, double q);

/// The smallest step from one value to the next that is not zero; 0 where all are equal.
double resolution(std::span<const double> values);

/// Standard deviation of the noise of a sensor, from the median of |x[i-1] - 2 x[i] + x[i+1]|,
/// which is 0.6745 sqrt(6) of it for independent normal noise. Steps do not disturb it, nor does
/// motion that is slow against the sample rate. Zero for fewer than three values, and where most
/// values repeat or lie on a line.
double noise_sigma(std::span<const double> values);

}  // namespace host_sim::recording
