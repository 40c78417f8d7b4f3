#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "host_sim/recording/stretch.hpp"

namespace host_sim::recording {

/// Value and slope at one sample of the polynomial that fits the samples around it best.
struct LocalFit {
  double value = 0;
  double slope_1_s = 0;
};

/// By a cubic over `reach_s` to each side, a quadratic where the end of the piece cuts that off
/// (Savitzky and Golay, 1964).
/// @return false where those are fewer than seven samples, and `fit` is left as it is
bool fit_locally(std::span<const double> time_s, std::span<const double> values,
                 const Stretch& piece, std::size_t i, double reach_s, LocalFit& fit);

/// The values of those fits; where there is none, and outside of the pieces, the values as they
/// are.
std::vector<double> smoothed(std::span<const double> time_s, std::span<const double> values,
                             std::span<const Stretch> pieces, double reach_s);

/// Means over as many samples to each side as lie within `reach_s` of the sample and are in its
/// piece, the same number on both sides: what is linear stays. Outside of the pieces the values as
/// they are.
std::vector<double> moving_mean(std::span<const double> time_s, std::span<const double> values,
                                std::span<const Stretch> pieces, double reach_s);

}  // namespace host_sim::recording
