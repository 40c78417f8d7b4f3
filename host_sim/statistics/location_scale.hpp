#pragma once

#include <span>
#include <vector>

#include "host_sim/statistics/fit.hpp"

namespace host_sim::statistics {

/// The distribution of a deviate z = (value - location) / scale.
enum class Standard {
  normal,
  smallest_extreme,  ///< of the logarithm of Weibull lives: scale 1 / beta, location ln alpha
};

/// Samples of one scale, each with a location of its own.
struct LocationScaleFit {
  std::vector<double> location;  ///< of each sample, in its values without what was subtracted
  double scale = 0;
  double log_likelihood = 0;  ///< densities per value, which may be a logarithm
  bool converged = false;
};

/// Maximum likelihood of lives that are known exactly, to be longer than something, or to lie
/// between two ends. In Olsen's coordinates (1978), slope = 1 / scale and offset = location /
/// scale, the likelihood of each such life is concave, so that Newton's steps, halved where they
/// lower it, find the maximum if there is one; else the fit has not converged.
/// @pre each sample is bounded()
LocationScaleFit fit_location_scale(std::span<const CentredSample> samples, Standard standard);

/// The same with a scale that is given.
LocationScaleFit fit_locations(std::span<const CentredSample> samples, Standard standard,
                               double scale);

}  // namespace host_sim::statistics
