#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "hal/result.hpp"
#include "hal/stm32g4/shunt_converters.hpp"
#include "lifemodel/quantity/units.hpp"

namespace hal::stm32g4 {

/// Largest integer whose square is at most `value`; 16 steps.
constexpr std::uint32_t square_root(std::uint32_t value) {
  std::uint32_t root = 0;
  for (std::uint32_t place = 1u << 30; place != 0; place >>= 2) {
    const std::uint32_t trial = root + place;
    root >>= 1;
    if (value >= trial) {
      value -= trial;
      root += place;
    }
  }
  return root;
}

/// Turns counts of three shunts into the amplitude of the motor current.
///
/// Three sinusoidal phase currents of amplitude I have i_u^2 + i_v^2 + i_w^2 = 3/2 I^2 at every
/// angle, so the amplitude needs no angle. It has no sign: a tendon only pulls.
class PhaseCurrent {
 public:
  /// 3.3 V / 4096 / (3 mohm * 64/7) of UM2516's amplifiers, as raw MotorCurrent: 29.4 mA.
  static constexpr std::uint32_t kRawPerCount = 492'800;
  /// Samples at rest for the zeros.
  static constexpr std::uint32_t kRestSamples = 256;
  /// A zero that is further from mid scale than this is a fault of the amplifier.
  static constexpr std::uint32_t kWidestZero = 512;
  /// A count within this of either end of the scale is clipped.
  static constexpr std::uint32_t kClipped = 8;
  /// The three currents add up to nothing, but for this: 4.7 A.
  static constexpr std::int32_t kLargestSum = 160;

  /// One of kRestSamples samples with the drive off.
  void take_rest(const PhaseCounts& counts) {
    for (std::size_t i = 0; i < kPhases; ++i) {
      zeros_[i] += counts[i];
    }
    ++rest_samples_;
  }
  /// After the last of them: failed, where an amplifier does not rest near mid scale.
  Error finish_rest() {
    known_ = false;
    for (const std::uint32_t zero : zeros_) {
      const std::uint32_t from = (2048 - kWidestZero) * kRestSamples;
      if (rest_samples_ != kRestSamples || zero < from ||
          zero - from > 2 * kWidestZero * kRestSamples) {
        return Error::failed;
      }
    }
    known_ = true;
    return Error::none;
  }

  /// failed: not calibrated, clipped, or the currents do not add up.
  [[nodiscard]] Result<lifemodel::MotorCurrent> isr_amplitude(const PhaseCounts& counts) const {
    std::int32_t sum = 0;
    std::uint32_t squares = 0;
    for (std::size_t i = 0; i < kPhases; ++i) {
      if (!known_ || counts[i] < kClipped || counts[i] > 4095 - kClipped) {
        return Error::failed;
      }
      // In eighths of a count: at most 2^15, so that three squares fit.
      const std::int32_t eighths =
          static_cast<std::int32_t>(counts[i] * 8) -
          static_cast<std::int32_t>((zeros_[i] + kRestSamples / 16) / (kRestSamples / 8));
      sum += eighths;
      squares += static_cast<std::uint32_t>(eighths * eighths);
    }
    if (sum > kLargestSum * 8 || sum < -kLargestSum * 8) {
      return Error::failed;
    }
    const std::uint32_t amplitude = square_root(squares / 3 * 2);
    constexpr std::uint32_t kHighest =
        static_cast<std::uint32_t>(lifemodel::kInt32Max) / (kRawPerCount / 8);
    if (amplitude > kHighest) {
      return Error::failed;
    }
    return lifemodel::MotorCurrent::from_raw(
        static_cast<std::int32_t>(amplitude * (kRawPerCount / 8)));
  }

 private:
  std::array<std::uint32_t, kPhases> zeros_{};  ///< sums over kRestSamples
  std::uint32_t rest_samples_ = 0;
  bool known_ = false;
};

}  // namespace hal::stm32g4
