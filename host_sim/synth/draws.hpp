#pragma once

#include <cstdint>

#include "host_sim/statistics/random.hpp"

namespace host_sim::synth {

/// Streams of statistics::Random: what is drawn for one purpose does not depend on what is drawn
/// for another.
enum Stream : std::uint64_t {
  kDesignStream = 1,
  kSessionStream,
  kOutputNoiseStream,
  kInputNoiseStream,
  kCurrentNoiseStream,
  kVelocityNoiseStream,
  kSheathNoiseStream,
  kWindingNoiseStream,
  kClockStream,
  kPoseStream,
  kStickSlipStream,
  kStrengthStream,
  kSecondModeStream,
  kLotStream,
  kEnduranceStream,
  kEarlyDeathStream,
  kOutputFloorStream,
  kInputFloorStream,
  kCurrentFloorStream,
  kOutputInstantStream,
  kInputInstantStream,
  kVelocityStepStream,
  kGainDriftStream,
};

/// A standard normal number: the quantile of one uniform number, the same on every machine.
double normal(statistics::Random& random);

/// A number of Student's t with `dof` degrees of freedom, scaled to a standard deviation of 1.
/// @pre dof > 2
double student_t(statistics::Random& random, double dof);

/// A standard exponential number.
double exponential(statistics::Random& random);

}  // namespace host_sim::synth
