#pragma once

#include <cstdint>
#include <random>

namespace host_sim::synth {

/// Random numbers of a campaign: std::mt19937_64 seeded by std::seed_seq, so that a plan and a seed
/// make the same campaign wherever and whenever.
class Random {
 public:
  Random(std::uint64_t seed, std::uint64_t stream, std::uint64_t number);

  /// Uniform in the open interval 0 .. 1.
  double uniform();

 private:
  std::mt19937_64 engine_;
};

/// Streams of Random: what is drawn for one purpose does not depend on what is drawn
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
double normal(Random& random);

/// A number of Student's t with `dof` degrees of freedom, scaled to a standard deviation of 1.
/// @pre dof > 2
double student_t(Random& random, double dof);

/// A standard exponential number.
double exponential(Random& random);

}  // namespace host_sim::synth
