#pragma once

#include <algorithm>
#include <cstdint>

#include "lifemodel/extension/fixed.hpp"
#include "lifemodel/input/capstan.hpp"
#include "lifemodel/quantity/units.hpp"

/// Samples, and what their sensors do to them.
namespace lifemodel::extension {

struct Celsius {};

/// Temperature in degrees Celsius, Q15.16.
using Temperature = Quantity<Celsius, std::int32_t, 16, -kInt32Max, kInt32Max, SaturateFlagged>;

/// Angle of the rotor in turns, Q31.32.
struct RotorAngle {
  std::int64_t raw;
  static constexpr int kFractionBits = 32;
};

/// What the effects depend on at one sample. Where a controller does not measure a quantity that an
/// effect needs, that effect has to be left out of its extension.
struct Covariates {
  Velocity velocity;
  RotorAngle rotor{};
  Temperature sheath;
  Temperature winding;
};

/// A sample of motor current, and what it was taken in.
struct DriveSample {
  MotorCurrent current;
  Covariates at;
};

/// A sample of output tension, and what it was taken in. The direction follows the velocity.
struct SheathSample {
  Tension tension;
  Angle bend;
  Covariates at;
};

/// Zero error of the current sensor: I - b.
struct CurrentOffset {
  std::int32_t offset = 0;  ///< b in A, Q24

  static constexpr std::int32_t kMost = 1 << 24;
  [[nodiscard]] constexpr bool plausible() const { return offset >= -kMost && offset <= kMost; }
  template <class Word>
  constexpr void words(Word&& word) {
    word(offset);
  }
};

/// Zero error of the sensor of output tension: T_out - b.
struct LoadCellZero {
  std::int32_t zero = 0;  ///< b relative to the ultimate tension, Q29

  static constexpr std::int32_t kMost = kUltimate.raw();
  [[nodiscard]] constexpr bool plausible() const { return zero >= -kMost && zero <= kMost; }
  template <class Word>
  constexpr void words(Word&& word) {
    word(zero);
  }
};

/// The inverse of a first-order lag: T + tau dT/dt, with the difference to the sample before.
struct FilterLag {
  std::int32_t periods = 0;  ///< tau in sample periods, Q16

  [[nodiscard]] constexpr bool plausible() const { return periods >= 0; }
  template <class Word>
  constexpr void words(Word&& word) {
    word(periods);
  }

  /// How far it may move a tension: an eighth of the ultimate one.
  static constexpr std::int64_t kMost = kUltimate.raw() / 8;

  [[nodiscard]] constexpr Tension undone(Tension before, Tension now, Flags& flags) const {
    // Beyond 2^31 the bound holds anyway.
    const std::int64_t step = std::clamp(std::int64_t{now.raw()} - before.raw(),
                                         -std::int64_t{kInt32Max}, std::int64_t{kInt32Max});
    const std::int64_t behind = std::clamp(rounded(step * periods, 16), -kMost, kMost);
    return Tension::saturated(now.raw() + behind, flags);
  }
};

}  // namespace lifemodel::extension
