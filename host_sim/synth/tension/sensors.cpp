#include "host_sim/synth/tension/sensors.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/synth/draws.hpp"

namespace host_sim::synth {

using enum hal::files::ProfileColumnId;

namespace {

using statistics::Random;

/// A jitter beyond this share of a sample time would let time run back.
constexpr double kMostJitter = 0.45;

void scale_by_noise(const Noise& noise, Random random, double resolution,
                    std::vector<double>& values) {
  const auto innovation = [&] {
    return noise.student_t_dof > 0 ? student_t(random, noise.student_t_dof) : normal(random);
  };
  const double innovation_share = std::sqrt(1 - noise.ar1 * noise.ar1);
  double state = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (noise.log_tension_sd > 0) {
      state = i == 0 ? innovation() : noise.ar1 * state + innovation_share * innovation();
    }
    values[i] = quantised(values[i] * std::exp(noise.log_tension_sd * state), resolution);
  }
}

void add_normal(double sd, Random random, double resolution, std::vector<double>& values) {
  for (double& value : values) {
    value = quantised(sd > 0 ? value + sd * normal(random) : value, resolution);
  }
}

void disturb_clock(const Noise& noise, Random random, std::vector<double>& time_s) {
  if (time_s.size() < 2) {
    return;
  }
  const double most_s = kMostJitter * (time_s[1] - time_s[0]);
  for (double& t : time_s) {
    const double jitter_s = noise.clock_jitter_s > 0 ? noise.clock_jitter_s * normal(random) : 0.0;
    t = t * (1 + noise.clock_drift_ppm * 1e-6) + std::clamp(jitter_s, -most_s, most_s);
  }
}

}  // namespace

double quantised(double value, double resolution) {
  return resolution > 0 ? std::round(value / resolution) * resolution : value;
}

void add_noise(const Noise& noise, std::uint64_t seed, std::size_t session, Channels& channels) {
  const auto random = [&](Stream stream) { return Random(seed, stream, session); };
  scale_by_noise(noise, random(kOutputNoiseStream), noise.tension_resolution_N,
                 channels[kOutputTensionColumn]);
  scale_by_noise(noise, random(kInputNoiseStream), noise.tension_resolution_N,
                 channels[kInputTensionColumn]);
  scale_by_noise(noise, random(kCurrentNoiseStream), noise.current_resolution_A,
                 channels[kMotorCurrentColumn]);
  add_normal(noise.velocity_sd_m_s, random(kVelocityNoiseStream), noise.velocity_resolution_m_s,
             channels[kTendonVelocity]);
  add_normal(noise.temperature_sd_C, random(kSheathNoiseStream), 0, channels[kSheathTemperature]);
  add_normal(noise.temperature_sd_C, random(kWindingNoiseStream), 0, channels[kWindingTemperature]);
  disturb_clock(noise, random(kClockStream), channels[kTime]);
}

}  // namespace host_sim::synth
