#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "lifemodel/extension/sample.hpp"
#include "lifemodel/pack/pack.hpp"
#include "lifemodel/quantity/flags.hpp"

/// What samples are made of, from physical units.
namespace lifemodel::pack {

/// The value nearest to this one; raises Flag::saturated beyond the range.
template <class Q>
Q saturating(double value, Flags& flags) {
  if (!(std::fabs(value) <= to_double(Q::highest()))) {
    flags.raise(Flag::saturated);
  }
  return from_double<Q>(value);
}

/// The same of the angle of a rotor.
inline extension::RotorAngle rotor_angle(double angle_rad, Flags& flags) {
  constexpr double kMost = 0x1p62;
  const double raw =
      std::ldexp(angle_rad / (2 * std::numbers::pi), extension::RotorAngle::kFractionBits);
  if (std::fabs(raw) > kMost) {
    flags.raise(Flag::saturated);
  }
  return {std::llround(std::clamp(raw, -kMost, kMost))};
}

/// What a sample was taken in.
struct Surroundings {
  double tendon_velocity_m_s = 0;
  double motor_angle_rad = 0;
  double sheath_temperature_C = 0;
  double winding_temperature_C = 0;
};

inline extension::Covariates covariates(const Surroundings& at, Flags& flags) {
  return {saturating<Velocity>(at.tendon_velocity_m_s, flags),
          rotor_angle(at.motor_angle_rad, flags),
          saturating<extension::Temperature>(at.sheath_temperature_C, flags),
          saturating<extension::Temperature>(at.winding_temperature_C, flags)};
}

}  // namespace lifemodel::pack
