#include "tests/recording/support.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "host_sim/statistics/random.hpp"

namespace host_sim::test {

using enum hal::files::ProfileColumnId;
using hal::files::ProfileColumnId;

namespace {

constexpr std::size_t kSamples = 4000;
constexpr double kRate_Hz = 200;

/// Phase in cycles of a motion that may stand still around 0 and 1/2.
double phase(const Rig& rig, double time_s) {
  const double cycles = rig.frequency_Hz * time_s + 0.03;
  if (!rig.holds) {
    return cycles;
  }
  const double half = 2 * cycles - std::floor(2 * cycles);
  return (std::floor(2 * cycles) + std::clamp((half - 0.1) / 0.8, 0.0, 1.0)) / 2;
}

double stroke(const Rig& rig, double time_s) {
  return (1 - std::cos(2 * std::numbers::pi * phase(rig, time_s))) / 2;
}

void measure(const Rig& rig, std::uint64_t stream, std::vector<double>& values) {
  const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
  const double range = *highest - *lowest;
  const double quantum = rig.resolution * range;
  statistics::Random random(rig.seed, stream, 0);
  for (double& value : values) {
    // Sum of uniform numbers: near enough to normal, and bounded.
    double sum = -6;
    for (int i = 0; i < 12; ++i) {
      sum += random.uniform();
    }
    value += rig.noise * range * sum;
    value = quantum > 0 ? quantum * std::round(value / quantum) : value;
  }
}

}  // namespace

recording::Recording recording_of(const Rig& rig) {
  recording::Recording recording;
  recording.session = std::string("s1");
  recording.specimen = std::string("a");
  recording::Channels& channels = recording.channels;
  double direction = 1;
  for (std::size_t i = 0; i < kSamples; ++i) {
    const double time_s = static_cast<double>(i) / kRate_Hz;
    const double velocity = 0.02 * (stroke(rig, time_s + 1e-5) - stroke(rig, time_s - 1e-5)) / 2e-5;
    direction = velocity == 0 ? direction : std::copysign(1, velocity);
    const double output_N = 25 + 25 * stroke(rig, time_s);
    const double input_N = output_N * std::exp(0.6 * direction);
    channels[kTime].push_back(time_s);
    channels[kInputTensionColumn].push_back(input_N);
    channels[kMotorCurrentColumn].push_back(input_N / 20);
    channels[kOutputTensionColumn].push_back(output_N);
    channels[kTendonVelocity].push_back(velocity);
    channels[kMotorAngle].push_back(14.4 * stroke(rig, time_s));
    channels[kBendAngle].push_back(270);
    channels[kSheathTemperature].push_back(std::floor(20 + time_s / 5));
    channels[kWindingTemperature].push_back(40);
  }
  for (unsigned id = kInputTensionColumn; id < kBendAngle; ++id) {
    measure(rig, id, channels[id]);
  }
  measure(rig, kMotorAngle, channels[kMotorAngle]);
  return recording;
}

void change(recording::Recording& recording, ProfileColumnId channel, double from_s, double to_s,
            const std::function<double(double)>& value) {
  for (std::size_t i = 0; i < recording.samples(); ++i) {
    const double time_s = recording[kTime][i];
    if (time_s >= from_s && time_s < to_s) {
      recording.channels[channel][i] = value(recording.channels[channel][i]);
    }
  }
}

}  // namespace host_sim::test
