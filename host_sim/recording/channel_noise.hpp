#pragma once

#include <vector>

#include "host_sim/recording/covariates.hpp"

namespace host_sim::recording {

/// White noise of one end's tension: a part that stays and one that goes with the tension.
struct ChannelNoise {
  double absolute_N = 0;  ///< standard deviation at no tension
  double relative = 0;    ///< of the tension

  [[nodiscard]] double variance_N2(double tension_N) const {
    const double share_N = relative * tension_N;
    return absolute_N * absolute_N + share_N * share_N;
  }
};

/// Noise of a tension from its third differences, which hardly anything of the motion reaches:
/// medians over samples of like tension, so that neither reversals nor outliers count.
/// Zero where there are fewer than 64 runs of four samples.
/// @param tension_N the channel of these covariates
ChannelNoise channel_noise(const Covariates& covariates, const std::vector<double>& tension_N);

/// Sets Covariates::input_noise and output_noise; leaves them empty where neither end shows any.
void add_noise(Covariates& covariates);

}  // namespace host_sim::recording
