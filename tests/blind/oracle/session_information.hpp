#pragma once

#include <Eigen/Core>
#include <vector>

namespace blind {

/// What disturbs the logarithm of a ratio of tensions.
struct Disturbance {
  double noise_sd = 0;     ///< of one sample
  double ar1 = 0;          ///< correlation from one sample to the next
  double gain_sd = 0;      ///< of a session's log gain
  double friction_sd = 0;  ///< of a session's friction coefficient
};

/// Information on three coefficients: of the effect's trace, gain and friction coefficient.
using Information = Eigen::Matrix3d;

/// What one session tells: X' V^-1 X, with the columns trace, 1 and -phi s, and with
/// V = R + gain_sd^2 1 1' + friction_sd^2 (phi s)(phi s)', R the AR(1) noise.
/// @param trace of each sample, the effect at its true size
/// @param signed_bend_rad phi s of each sample
Information session_information(const std::vector<double>& trace,
                                const std::vector<double>& signed_bend_rad,
                                const Disturbance& disturbance);

/// Size of the effect over the standard deviation of its estimate: the square root of what is left
/// of its information beside gain and friction coefficient.
double sigmas_of(const Information& information);

}  // namespace blind
