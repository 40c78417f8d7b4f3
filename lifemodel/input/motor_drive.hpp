#pragma once

#include <cstdint>

#include "lifemodel/quantity/units.hpp"

namespace lifemodel {

/// A factor of two fixed-point formats: mantissa * 2^-shift, mantissa 2^30 .. 2^31 - 1.
struct Factor {
  std::int32_t mantissa;
  std::int32_t shift;

  static constexpr std::int32_t kLowestShift = 1;
  static constexpr std::int32_t kHighestShift = 62;
  [[nodiscard]] constexpr bool plausible() const {
    return mantissa >= (1 << 30) && shift >= kLowestShift && shift <= kHighestShift;
  }
  /// The product, to the nearest step.
  [[nodiscard]] constexpr std::int64_t times(std::int32_t value) const {
    const std::int64_t rounding = std::int64_t{1} << (shift - 1);
    return (std::int64_t{value} * mantissa + rounding) >> shift;
  }
};

/// Tension in mN to tension relative to the ultimate tension.
struct TensionScale {
  Factor steps_per_mN;

  /// Saturates outside the range of Tension and then raises Flag::saturated in `flags`.
  [[nodiscard]] constexpr Tension tension(std::int32_t tension_mN, Flags& flags) const {
    return Tension::saturated(steps_per_mN.times(tension_mN), flags);
  }
};

/// Motor current to input tension: T_in = K_t (I - I_0) N eta_g / r_spool, the same in both
/// directions.
struct MotorDrive {
  MotorCurrent offset;  ///< I_0
  Factor gain;          ///< steps of tension for each step of current

  /// Saturates outside the range of Tension and then raises Flag::saturated in `flags`.
  [[nodiscard]] constexpr Tension tension(MotorCurrent current, Flags& flags) const {
    const MotorCurrent net = MotorCurrent::difference(current, offset, flags);
    return Tension::saturated(gain.times(net.raw()), flags);
  }
};

}  // namespace lifemodel
