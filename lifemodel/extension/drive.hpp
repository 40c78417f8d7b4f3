#pragma once

#include <cstdint>

#include "lifemodel/extension/fixed.hpp"
#include "lifemodel/extension/sample.hpp"
#include "lifemodel/input/capstan.hpp"
#include "lifemodel/numeric/sine.hpp"

/// Effects between the motor current and the input tension.
namespace lifemodel::extension {

/// Cogging and torque ripple: I + a sin(k theta) + b cos(k theta).
struct TorqueRipple {
  std::int32_t sine = 0;      ///< a in A, Q24
  std::int32_t cosine = 0;    ///< b in A, Q24
  std::int32_t harmonic = 0;  ///< k, Q16

  static constexpr std::int32_t kMost = 1 << 24;
  [[nodiscard]] constexpr bool plausible() const {
    return sine >= -kMost && sine <= kMost && cosine >= -kMost && cosine <= kMost && harmonic > 0;
  }
  template <class Word>
  constexpr void words(Word&& word) {
    word(sine);
    word(cosine);
    word(harmonic);
  }

  /// What it adds to the current, Q24.
  [[nodiscard]] constexpr std::int64_t added(RotorAngle rotor) const {
    // Whole turns drop out of the product.
    const std::uint64_t turns =
        static_cast<std::uint64_t>(rotor.raw) * static_cast<std::uint32_t>(harmonic);
    const auto phase = static_cast<numeric::Phase>(turns >> 16);
    return rounded(
        std::int64_t{sine} * numeric::sine(phase) + std::int64_t{cosine} * numeric::cosine(phase),
        30);
  }
};

/// A torque constant that falls as the winding warms: K_t (1 - alpha (T_winding - T_ref)).
struct TorqueGain {
  std::int32_t droop = 0;      ///< alpha in 1/K, Q30
  std::int32_t reference = 0;  ///< T_ref in degrees Celsius, Q16

  static constexpr std::int32_t kMost = 1 << 27;
  /// The factor does not fall below 0.05.
  static constexpr std::int32_t kLeast = 13421773;
  [[nodiscard]] constexpr bool plausible() const { return droop >= 0 && droop <= kMost; }
  template <class Word>
  constexpr void words(Word&& word) {
    word(droop);
    word(reference);
  }

  /// The factor of K_t, Q28.
  [[nodiscard]] constexpr std::int32_t factor(Temperature winding) const {
    const std::int64_t warmer = std::int64_t{winding.raw()} - reference;
    const std::int32_t factor =
        factor_of(-rounded(warmer * droop, 30 + Temperature::kFractionBits - kFactorBits));
    return factor < kLeast ? kLeast : factor;
  }
};

/// Direction-dependent efficiency of the gear: eta_g (1 + c s).
struct GearAsymmetry {
  std::int32_t asymmetry = 0;  ///< c, Q28

  static constexpr std::int32_t kMost = kOne / 2;
  [[nodiscard]] constexpr bool plausible() const {
    return asymmetry >= -kMost && asymmetry <= kMost;
  }
  template <class Word>
  constexpr void words(Word&& word) {
    word(asymmetry);
  }

  /// The factor of eta_g, Q28.
  [[nodiscard]] constexpr std::int32_t factor(Direction direction) const {
    return direction == Direction::pulling ? kOne + asymmetry : kOne - asymmetry;
  }
};

}  // namespace lifemodel::extension
