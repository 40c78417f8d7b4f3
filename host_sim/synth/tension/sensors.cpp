#include "host_sim/synth/tension/sensors.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/synth/draws.hpp"

namespace host_sim::synth {

using enum hal::files::ProfileColumnId;

namespace {

/// A jitter beyond this share of a sample time would let time run back.
constexpr double kMostJitter = 0.45;

/// AR(1) noise of standard deviation 1 from sample to sample.
class Correlated {
 public:
  Correlated(double ar1, double student_t_dof, Random random)
      : ar1_(ar1), dof_(student_t_dof), random_(random) {}

  double next() {
    state_ = first_ ? innovation() : ar1_ * state_ + std::sqrt(1 - ar1_ * ar1_) * innovation();
    first_ = false;
    return state_;
  }

 private:
  double innovation() { return dof_ > 0 ? student_t(random_, dof_) : normal(random_); }

  double ar1_, dof_;
  Random random_;
  double state_ = 0;
  bool first_ = true;
};

struct Parts {
  double relative_sd, absolute_sd, resolution;
};

void add_parts(const Parts& parts, Correlated relative, Correlated absolute,
               std::vector<double>& values) {
  for (double& value : values) {
    if (parts.relative_sd > 0) {
      value *= std::exp(parts.relative_sd * relative.next());
    }
    if (parts.absolute_sd > 0) {
      value += parts.absolute_sd * absolute.next();
    }
    value = quantised(value, parts.resolution);
  }
}

void add_normal(double sd, Random random, double resolution, std::vector<double>& values) {
  for (double& value : values) {
    value = quantised(sd > 0 ? value + sd * normal(random) : value, resolution);
  }
}

std::vector<double> jitter(double sd_s, double most_s, Random random, std::size_t samples) {
  std::vector<double> offsets_s(samples);
  for (double& offset_s : offsets_s) {
    offset_s = std::clamp(sd_s * normal(random), -most_s, most_s);
  }
  return offsets_s;
}

void disturb_clock(const Noise& noise, Random random, std::vector<double>& time_s) {
  if (time_s.size() < 2) {
    return;
  }
  const double rate = 1 + noise.clock_drift_ppm * 1e-6;
  const double most_s = kMostJitter * rate * (time_s[1] - time_s[0]);
  for (double& t : time_s) {
    const double jitter_s = noise.clock_jitter_s > 0 ? noise.clock_jitter_s * normal(random) : 0.0;
    t = t * rate + std::clamp(jitter_s, -most_s, most_s);
  }
}

}  // namespace

double quantised(double value, double resolution) {
  return resolution > 0 ? std::round(value / resolution) * resolution : value;
}

Instants draw_instants(const Noise& noise, std::uint64_t seed, std::size_t session,
                       std::size_t samples, double sample_rate_Hz) {
  if (noise.jitter_s <= 0) {
    return {};
  }
  const double most_s = kMostJitter / sample_rate_Hz;
  return {jitter(noise.jitter_s, most_s, {seed, kOutputInstantStream, session}, samples),
          jitter(noise.jitter_s, most_s, {seed, kInputInstantStream, session}, samples)};
}

void add_noise(const Noise& noise, std::uint64_t seed, std::size_t session, Channels& channels) {
  const auto random = [&](Stream stream) { return Random(seed, stream, session); };
  const auto correlated = [&](const EndNoise& end, Stream stream) {
    return Correlated(end.ar1, noise.student_t_dof, random(stream));
  };
  const EndNoise& output = noise.output;
  const EndNoise& input = noise.input;
  add_parts({output.relative_sd, output.absolute_N, noise.tension_resolution_N},
            correlated(output, kOutputNoiseStream), correlated(output, kOutputFloorStream),
            channels[kOutputTensionColumn]);
  add_parts({input.relative_sd, input.absolute_N, noise.tension_resolution_N},
            correlated(input, kInputNoiseStream), correlated(input, kInputFloorStream),
            channels[kInputTensionColumn]);
  add_parts({input.relative_sd, input.absolute_A, noise.current_resolution_A},
            correlated(input, kCurrentNoiseStream), correlated(input, kCurrentFloorStream),
            channels[kMotorCurrentColumn]);
  add_normal(noise.velocity_sd_m_s, random(kVelocityNoiseStream), noise.velocity_resolution_m_s,
             channels[kTendonVelocity]);
  add_normal(noise.temperature_sd_C, random(kSheathNoiseStream), 0, channels[kSheathTemperature]);
  add_normal(noise.temperature_sd_C, random(kWindingNoiseStream), 0, channels[kWindingTemperature]);
  disturb_clock(noise, random(kClockStream), channels[kTime]);
}

}  // namespace host_sim::synth
