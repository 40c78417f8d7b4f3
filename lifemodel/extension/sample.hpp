#pragma once

#include <cstdint>

#include "lifemodel/input/capstan.hpp"
#include "lifemodel/quantity/units.hpp"

namespace lifemodel::extension {

struct MetrePerSecond {};
struct Celsius {};

/// Velocity of the tendon, positive while pulling, Q7.24: resolution 60 nm/s, range +-128 m/s.
using Velocity = Quantity<MetrePerSecond, std::int32_t, 24, -kInt32Max, kInt32Max, SaturateFlagged>;

/// Temperature in degrees Celsius, Q15.16.
using Temperature = Quantity<Celsius, std::int32_t, 16, -kInt32Max, kInt32Max, SaturateFlagged>;

/// Angle of the rotor in turns, Q31.32.
struct RotorAngle {
  std::int64_t raw;
  static constexpr int kFractionBits = 32;
};

/// What a tendon moves in at one sample. Where a controller does not measure a quantity that an
/// effect needs, that effect has to be left out of its extension.
struct Conditions {
  Velocity velocity;
  RotorAngle rotor{};
  Temperature sheath;
  Temperature winding;
};

/// A sample of motor current, and what it was taken in.
struct DriveSample {
  MotorCurrent current;
  Conditions at;
};

/// A sample of output tension, and what it was taken in. The direction follows the velocity.
struct SheathSample {
  Tension tension;
  Angle bend;
  Conditions at;
};

}  // namespace lifemodel::extension
