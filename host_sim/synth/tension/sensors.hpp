#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "hal/files/profile_columns.hpp"

namespace host_sim::synth {

/// What is recorded in one session, by ProfileColumnId, in the unit of each column.
using Channels = std::array<std::vector<double>, hal::files::kProfileColumnCount>;

/// Noise at one end of the sheath: a part in proportion to the reading and a part that is not, each
/// drawn on its own.
struct EndNoise {
  double relative_sd = 0;  ///< of the logarithm of the reading
  double absolute_N = 0;   ///< sd of a tension
  double absolute_A = 0;   ///< sd of a current
  double ar1 = 0;          ///< correlation from sample to sample, of both parts; the sds stay
};

/// What sensors and recorder add to all sessions of a plan. Resolutions of 0 leave values alone.
struct Noise {
  EndNoise output = {}, input = {};  ///< at the load, and at the drive whatever measures there
  double jitter_s = 0;               ///< sd of the instant at which an end is read, each on its own
  double student_t_dof = 0;          ///< of the innovations; 0 is normal
  double tension_resolution_N = 0;
  double current_resolution_A = 0;
  double velocity_sd_m_s = 0;
  double velocity_resolution_m_s = 0;
  double temperature_sd_C = 0;
  double clock_jitter_s = 0;   ///< sd of the time of a sample; less than a third of a step
  double clock_drift_ppm = 0;  ///< of the recorder against true time
};

/// How far from the times of its samples each end is read, in the order of the samples; empty is in
/// time.
struct Instants {
  std::vector<double> output_s, input_s;
};

/// Draws them for one session.
Instants draw_instants(const Noise& noise, std::uint64_t seed, std::size_t session,
                       std::size_t samples, double sample_rate_Hz);

/// Adds noise to what a session would be without: the same numbers for the same seed and session.
void add_noise(const Noise& noise, std::uint64_t seed, std::size_t session, Channels& channels);

/// The multiple of `resolution` next to a value; the value where the resolution is 0.
double quantised(double value, double resolution);

}  // namespace host_sim::synth
