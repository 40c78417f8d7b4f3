#pragma once

#include <cstdint>

#include "lifemodel/quantity/units.hpp"

namespace lifemodel {

/// Motor current to input tension: T_in = K_t (I - I_0) N eta_g / r_spool, the same in both
/// directions.
struct MotorDrive {
  MotorCurrent offset;         ///< I_0
  std::int32_t gain_mantissa;  ///< tension steps for each current step, mantissa * 2^-shift
  std::int32_t gain_shift;     ///< 1 .. 62

  static constexpr std::int32_t kLowestShift = 1;
  static constexpr std::int32_t kHighestShift = 62;

  /// Saturates outside the range of Tension and then raises Flag::saturated in `flags`.
  [[nodiscard]] constexpr Tension tension(MotorCurrent current, Flags& flags) const {
    const MotorCurrent net = MotorCurrent::difference(current, offset, flags);
    const std::int64_t product = std::int64_t{net.raw()} * gain_mantissa;
    const std::int64_t rounding = std::int64_t{1} << (gain_shift - 1);
    return Tension::saturated((product + rounding) >> gain_shift, flags);
  }
};

}  // namespace lifemodel
