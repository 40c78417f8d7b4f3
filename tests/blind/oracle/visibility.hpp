#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "host_sim/synth/tension/sensors.hpp"
#include "tests/blind/generator/scenario.hpp"

namespace blind {

/// ln of output over input of each sample; input is a tension or a current, for gain takes up the
/// factor between them.
std::vector<double> log_ratio(const host_sim::synth::Channels& channels, Input input);

/// phi s of each sample; s is 1 while pulling, also before the first motion, and -1 while letting
/// go.
std::vector<double> signed_bend_rad(const host_sim::synth::Channels& channels);

/// One source of noise in the logarithm of a ratio of tensions: an AR(1) process of standard
/// deviation 1, times a standard deviation for each sample.
struct NoiseSource {
  std::vector<double> sd;
  double ar1 = 0;  ///< correlation from one sample to the next
};

/// What disturbs the logarithm of a ratio of tensions in one session.
struct Disturbance {
  std::vector<NoiseSource> noise;  ///< independent of each other
  double gain_sd = 0;              ///< of a session's log gain
  double friction_sd = 0;          ///< of a session's friction coefficient
};

/// The noise of both ends where `channels` are what is measured without it: in proportion, not in
/// proportion, and by jitter, which counts by the slope of the channel.
std::vector<NoiseSource> noise_sources(const host_sim::synth::Noise& noise,
                                       const host_sim::synth::Channels& channels, Input input);

/// Information on three coefficients: of the effect's trace, gain and friction coefficient.
using Information = Eigen::Matrix3d;

/// The information of one session: X' V^-1 X, and V = R + gain_sd^2 g g' + friction_sd^2 f f', R
/// of the sum of all noise.
/// @param columns X: of each sample the trace of the effect at its true size, and what a unit of
///   the session's gain (g) and of its friction coefficient (f) do beside everything else
Information session_information(const Eigen::MatrixX3d& columns, const Disturbance& disturbance);

/// Size of the effect over the standard deviation of its estimate: the square root of what is left
/// of its information beside gain and friction coefficient.
double sigmas_of(const Information& information);

/// The same for a campaign of lives: each specimen's logarithm of cycles against that of the same
/// specimen without the effect, less what scale and exponent of the law take up by least squares,
/// in standard deviations of one specimen, pi / (sqrt(6) beta). What suspension hides does not
/// count. Changes of scatter are reported as those of these very specimens.
/// @param id of a hidden effect
double life_visibility(const Scenario& scenario, const std::string& id);

/// The first attempt at a campaign of lives whose hidden effects an oracle sees at three standard
/// deviations or more, which is what is called barely visible; after many the last, which the
/// tables count apart.
Scenario draw_visible_lives(std::uint64_t seed);

/// At how many standard deviations an oracle sees each hidden effect of a campaign. Of recordings
/// it knows the exact trace that the effect leaves (the simulation with everything against that
/// without the effect, both without noise), the noise and the scatter of sessions, and estimates
/// the effect's size beside gain and friction coefficient by generalised least squares; of forces
/// of either sign in newtons, else in logarithms. Of lives see life_visibility().
std::vector<double> visibility_of(const Scenario& scenario);

/// The error that the true model would leave: RMSE of the output tension of the same campaign with
/// nothing hidden, with gain and friction coefficient fitted by least squares of the logarithm. 0
/// for lives and for forces of either sign.
double rmse_floor_N(const Scenario& scenario);

/// Share of the true model's gain that an analysis reached: how far it brought an error down, over
/// how far the floor lies below it. All in one unit.
double relative_gain(double before, double after, double floor);

}  // namespace blind
