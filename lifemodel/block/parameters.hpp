#pragma once

#include <cstdint>

#include "lifemodel/damage/cycle_law.hpp"
#include "lifemodel/input/capstan.hpp"
#include "lifemodel/input/motor_drive.hpp"
#include "lifemodel/input/tension_scale.hpp"
#include "lifemodel/life/weibull.hpp"
#include "lifemodel/quantity/units.hpp"

namespace lifemodel {

/// What the estimator has to know about one tendon. Comes out of a parameter block that has been
/// checked; see parameter_block.hpp.
struct Parameters {
  std::uint32_t model_digest;  ///< CRC-32 of the model that the block was computed from
  TensionRange hysteresis;     ///< smallest range that is counted, at least one step
  std::uint32_t ultimate_mN;   ///< the ultimate tension, for conversions
  TensionScale scale;
  CycleLaw law;
  LifeDistribution life;
  Capstan capstan;
  Angle bend;        ///< where the bend angle is not measured
  MotorDrive drive;  ///< its gain is 0 where the model has no drive
  std::uint32_t sample_period_us;

  [[nodiscard]] constexpr bool has_drive() const { return drive.gain.mantissa != 0; }
};

}  // namespace lifemodel
