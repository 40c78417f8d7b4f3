#pragma once

#include <cstdint>

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
};

}  // namespace host_sim::synth
