#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

#include "hal/files/interruption.hpp"
#include "host_sim/synth/tension/rig.hpp"

namespace host_sim::synth {

/// One end of the sheath, read at instants of its own; between those of the simulation it lies on a
/// line.
class Reader {
 public:
  Reader(const std::vector<double>& offsets_s, double rate_Hz, std::vector<double>& readings)
      : offsets_s_(offsets_s), rate_Hz_(rate_Hz), readings_(readings) {}

  /// The simulation has got to a time.
  void pass(double time_s, double value) {
    for (double at_s = next_s(); at_s <= time_s; at_s = next_s()) {
      const double back = time_s > last_s_ ? (time_s - at_s) / (time_s - last_s_) : 0;
      readings_.push_back(value - (value - last_) * back);
    }
    last_s_ = time_s;
    last_ = value;
  }

 private:
  [[nodiscard]] double next_s() const {
    const std::size_t i = readings_.size();
    const double offset_s = offsets_s_.empty()      ? 0
                            : i < offsets_s_.size() ? offsets_s_[i]
                                                    : std::numeric_limits<double>::infinity();
    return std::max(0.0, static_cast<double>(i) / rate_Hz_ + offset_s);
  }

  const std::vector<double>& offsets_s_;
  double rate_Hz_;
  std::vector<double>& readings_;
  double last_s_ = 0;
  double last_ = 0;
};

/// What one session of a rig records.
class Recorder {
 public:
  Recorder(const Rig& rig, const Instants& instants, Channels& channels)
      : output(instants.output_s, rig.sample_rate_Hz, channels[Column::kOutputTensionColumn]),
        input(instants.input_s, rig.sample_rate_Hz, channels[Column::kInputTensionColumn]),
        current(instants.input_s, rig.sample_rate_Hz, channels[Column::kMotorCurrentColumn]),
        rig_(rig),
        channels_(channels) {}

  /// The motion, which is read in time.
  void sample(const Covariates& covariates) {
    constexpr double kDegPerRad = 180 / std::numbers::pi;
    channels_[Column::kTime].push_back(covariates.time_s);
    channels_[Column::kTendonVelocity].push_back(covariates.velocity_m_s);
    channels_[Column::kBendAngle].push_back(covariates.bend_angle_rad * kDegPerRad);
    if (rig_.drive) {
      channels_[Column::kMotorAngle].push_back(covariates.position_m * rig_.drive->gear_ratio /
                                               rig_.drive->spool_radius_m());
    }
  }

  /// Integrates a session at kLeastRate_Hz or faster.
  /// @param go_to takes the simulation to a time; the first is 0
  /// @param sample reads what is read in time, at the time that was gone to last
  template <class GoTo, class Sample>
  void run(const GoTo& go_to, const Sample& sample) {
    const std::size_t samples = samples_of(rig_);
    const auto steps = static_cast<std::size_t>(std::ceil(kLeastRate_Hz / rig_.sample_rate_Hz));
    go_to(0.0);
    for (std::size_t i = 0; i < samples; ++i) {
      if (i % kSamplesBetweenChecks == 0) {
        hal::files::stop_if_interrupted();
      }
      sample();
      for (std::size_t step = 1; step <= steps; ++step) {
        const double share = static_cast<double>(step) / static_cast<double>(steps);
        go_to((static_cast<double>(i) + share) / rig_.sample_rate_Hz);
      }
    }
    for (const auto id :
         {Column::kOutputTensionColumn, Column::kInputTensionColumn, Column::kMotorCurrentColumn}) {
      channels_[id].resize(std::min(channels_[id].size(), samples));
    }
  }

  Reader output, input, current;

 private:
  using Column = hal::files::ProfileColumnId;
  static constexpr std::size_t kSamplesBetweenChecks = 4096;

  const Rig& rig_;
  Channels& channels_;
};

}  // namespace host_sim::synth
