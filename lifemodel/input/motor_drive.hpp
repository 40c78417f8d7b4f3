#pragma once

#include "lifemodel/input/factor.hpp"
#include "lifemodel/quantity/units.hpp"

namespace lifemodel {

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
