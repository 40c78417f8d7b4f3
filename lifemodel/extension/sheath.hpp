#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "lifemodel/extension/fixed.hpp"
#include "lifemodel/extension/sample.hpp"
#include "lifemodel/input/capstan.hpp"
#include "lifemodel/input/motor_drive.hpp"
#include "lifemodel/numeric/sine.hpp"
#include "lifemodel/quantity/units.hpp"

/// Effects between the output tension and the input tension.
namespace lifemodel::extension {

/// Error of the bend angle: mu (phi + delta), with the delta of the pose next in phi.
struct BendAngle {
  static constexpr std::size_t kPoses = 8;
  struct Pose {
    std::int32_t angle = 0;  ///< rad, Q26
    std::int32_t error = 0;
  };
  std::int32_t poses = 0;
  std::array<Pose, kPoses> pose{};

  [[nodiscard]] constexpr bool plausible() const {
    if (poses < 1 || poses > static_cast<std::int32_t>(kPoses)) {
      return false;
    }
    for (const Pose& each : pose) {
      constexpr std::int32_t kMost = 1 << Angle::kFractionBits;
      if (!Angle::checked(each.angle) || each.error < -kMost || each.error > kMost) {
        return false;
      }
    }
    return true;
  }
  template <class Word>
  constexpr void words(Word&& word) {
    word(poses);
    for (Pose& each : pose) {
      word(each.angle);
      word(each.error);
    }
  }

  [[nodiscard]] constexpr Angle corrected(Angle nominal) const {
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < static_cast<std::size_t>(poses); ++i) {
      nearest = away(i, nominal) < away(nearest, nominal) ? i : nearest;
    }
    return Angle::from_raw(
        held(std::int64_t{nominal.raw()} + pose[nearest].error, 0, Angle::highest().raw()));
  }

 private:
  [[nodiscard]] constexpr std::int32_t away(std::size_t i, Angle nominal) const {
    const std::int32_t difference = nominal.raw() - pose[i].angle;
    return difference < 0 ? -difference : difference;
  }
};

/// Load-dependent friction, mu (T/50 N)^-k at each place of the sheath. Along it
/// ln(T_in/T_out) = ln(1 + z)/k with z = k mu phi s (T_out/50 N)^-k.
struct FrictionLoad {
  std::int32_t exponent = 0;        ///< k, Q28, -1 .. 1
  std::int32_t log2_reference = 0;  ///< log2 of 50 N in steps of Tension, Q26
  Factor inverse{1 << 30, 31};      ///< 1/|k|, of Q24 in Q21

  [[nodiscard]] constexpr bool plausible() const {
    return exponent >= -kOne && exponent <= kOne && inverse.plausible();
  }
  template <class Word>
  constexpr void words(Word&& word) {
    word(exponent);
    word(log2_reference);
    word(inverse.mantissa);
    word(inverse.shift);
  }

  /// log2(T_in/T_out), Q21, where it would be `plain` without load dependence. Raises
  /// Flag::saturated where 1 + z is held at 1/1024.
  [[nodiscard]] constexpr std::int64_t log2_ratio(std::int64_t plain, Tension output,
                                                  Flags& flags) const {
    if (output.raw() <= 0) {
      return plain;
    }
    const std::int64_t here = at_load(plain, output);
    // z in Q28: k times the exponent to base e.
    constexpr std::int64_t kLn2 = 186065279;  // Q28
    const std::int64_t log2_z = rounded(here * exponent, kExponentBits);
    std::int64_t z = rounded(std::clamp(log2_z, -kMostZ, kMostZ) * kLn2, kFactorBits);
    constexpr std::int64_t kLeast = kOne / 1024 - kOne;
    if (z < kLeast) {
      flags.raise(Flag::saturated);
      z = kLeast;
    }
    constexpr std::int64_t kSmall = kOne / 8;
    return z > -kSmall && z < kSmall ? rounded(here * series(z), kFactorBits) : quotient(z);
  }

 private:
  static constexpr std::int64_t kMostZ = std::int64_t{1} << 33;

  /// The exponent with mu at the load of the output, Q21.
  [[nodiscard]] constexpr std::int64_t at_load(std::int64_t plain, Tension output) const {
    const std::int64_t log2_load =
        std::int64_t{log2_of(static_cast<std::uint32_t>(output.raw()))} - log2_reference;
    const std::int64_t power =
        -rounded(log2_load * exponent, numeric::kLogBits + kFactorBits - kExponentBits);
    const auto whole = static_cast<int>(power >> kExponentBits);
    const std::int64_t fraction =
        numeric::exp2_fraction(static_cast<std::uint32_t>(power) & ((1u << kExponentBits) - 1));
    constexpr std::int64_t kMost = std::int64_t{1} << 33;
    return std::clamp(rounded(plain * fraction, std::clamp(31 - whole, 1, 62)), -kMost, kMost);
  }

  /// ln(1 + z)/z in Q28 for |z| <= 1/8, by its power series.
  static constexpr std::int64_t series(std::int64_t z) {
    std::int64_t sum = 0;
    for (int term = 9; term >= 1; --term) {
      const std::int64_t one_over = kOne / term;
      sum = one_over - rounded(sum * z, kFactorBits);
    }
    return sum;
  }

  /// log2(1 + z)/k in Q21.
  [[nodiscard]] constexpr std::int64_t quotient(std::int64_t z) const {
    const std::int64_t term = std::min(kOne + z, (std::int64_t{1} << 32) - 1);
    const std::int32_t log2_term =
        log2_of(static_cast<std::uint32_t>(term)) - (kFactorBits << numeric::kLogBits);
    const std::int64_t result = inverse.times(log2_term >> 2);
    return exponent < 0 ? -result : result;
  }
};

/// Position-dependent friction: mu (1 + g(x)), g a Fourier sum of six harmonics of 2 pi x/L. The
/// position is that of the rotor.
struct FrictionPosition {
  struct Harmonic {
    std::int32_t sine = 0;  ///< Q28
    std::int32_t cosine = 0;
  };
  std::array<Harmonic, 6> harmonics{};
  std::int32_t waves_a_turn = 0;  ///< wavelengths that a turn of the rotor goes, Q28

  static constexpr std::int32_t kMost = kOne;
  [[nodiscard]] constexpr bool plausible() const {
    for (const Harmonic& each : harmonics) {
      if (each.sine < -kMost || each.sine > kMost || each.cosine < -kMost || each.cosine > kMost) {
        return false;
      }
    }
    return waves_a_turn > 0;
  }
  template <class Word>
  constexpr void words(Word&& word) {
    for (Harmonic& each : harmonics) {
      word(each.sine);
      word(each.cosine);
    }
    word(waves_a_turn);
  }

  /// The factor of mu, Q28.
  [[nodiscard]] constexpr std::int32_t factor(RotorAngle rotor) const {
    // Whole waves drop out of the product, however far the rotor has turned.
    const std::uint64_t waves =
        static_cast<std::uint64_t>(rotor.raw) * static_cast<std::uint32_t>(waves_a_turn);
    const auto phase = static_cast<numeric::Phase>(waves >> kFactorBits);
    numeric::Phase multiple = 0;
    std::int64_t sum = 0;
    for (const Harmonic& each : harmonics) {
      multiple += phase;
      sum += std::int64_t{each.sine} * numeric::sine(multiple) +
             std::int64_t{each.cosine} * numeric::cosine(multiple);
    }
    return factor_of(rounded(sum, 30));
  }
};

/// Load-independent friction of seals and sheath preload: T_in + F s, with the position of friction
/// F (1 + g(x)) s.
struct FrictionPreload {
  std::int32_t force = 0;  ///< F relative to the ultimate tension, Q29

  [[nodiscard]] constexpr bool plausible() const { return force >= 0; }
  template <class Word>
  constexpr void words(Word&& word) {
    word(force);
  }
};

/// Temperature-dependent friction: mu (1 + k (T_sheath - T_ref)).
struct FrictionTemperature {
  std::int32_t coefficient = 0;  ///< k in 1/K, Q30
  std::int32_t reference = 0;    ///< T_ref in degrees Celsius, Q16

  static constexpr std::int32_t kMost = 1 << 27;
  [[nodiscard]] constexpr bool plausible() const {
    return coefficient >= -kMost && coefficient <= kMost;
  }
  template <class Word>
  constexpr void words(Word&& word) {
    word(coefficient);
    word(reference);
  }

  /// The factor of mu, Q28.
  [[nodiscard]] constexpr std::int32_t factor(Temperature sheath) const {
    const std::int64_t warmer = std::int64_t{sheath.raw()} - reference;
    return factor_of(rounded(warmer * coefficient, 30 + Temperature::kFractionBits - kFactorBits));
  }
};

/// Stribeck and viscous friction: mu + (mu_s - mu) exp(-|v|/v_s) + kappa |v|.
struct FrictionVelocity {
  std::int32_t stribeck = 0;      ///< (mu_s - mu) log2(e), Q28
  std::int32_t viscous = 0;       ///< kappa log2(e) in s/m, Q24
  std::int32_t log2_a_speed = 0;  ///< log2(e)/v_s in s/m, Q16

  [[nodiscard]] constexpr bool plausible() const {
    return stribeck >= -kOne && stribeck <= kOne && viscous >= -kMostViscous &&
           viscous <= kMostViscous && log2_a_speed > 0;
  }
  template <class Word>
  constexpr void words(Word&& word) {
    word(stribeck);
    word(viscous);
    word(log2_a_speed);
  }

  /// What it adds to mu log2(e), Q28.
  [[nodiscard]] constexpr std::int64_t added(Velocity velocity) const {
    const std::int64_t speed = velocity.raw() < 0 ? -velocity.raw() : velocity.raw();
    constexpr int kDrop = Velocity::kFractionBits + 16 - kExponentBits;
    const std::int64_t slow = exp2_factor(-rounded(speed * log2_a_speed, kDrop));
    return rounded(stribeck * slow, kFactorBits) +
           rounded(viscous * speed, 24 + Velocity::kFractionBits - kFactorBits);
  }

 private:
  static constexpr std::int32_t kMostViscous = 127 << 24;
};

/// Load-independent viscous friction: T_in + c |v| s.
struct ViscousForce {
  Factor force_a_velocity{1 << 30,
                          62};  ///< c in Q29 of the ultimate tension for a step of velocity

  [[nodiscard]] constexpr bool plausible() const { return force_a_velocity.plausible(); }
  template <class Word>
  constexpr void words(Word&& word) {
    word(force_a_velocity.mantissa);
    word(force_a_velocity.shift);
  }

  /// c |v|, Q29.
  [[nodiscard]] constexpr std::int64_t size(Velocity velocity) const {
    return force_a_velocity.times(velocity.raw() < 0 ? -velocity.raw() : velocity.raw());
  }
};

/// Friction that turns over along the way: in place of its direction s a slip z with
/// z - s = (z_turn - s) exp(-x/l) at the travel x since the motion turned; by a share,
/// s + share (z - s).
struct Presliding {
  /// Of travel, a sum of velocities Q24 over samples: bits that are dropped before the product.
  std::int32_t drop = 0;
  Factor lengths{1 << 30, 31};  ///< log2(e)/l for a step of what is left, in Q21
  std::int32_t share = kOne;    ///< Q28, 0 .. 1

  static constexpr std::int32_t kMostDrop = 40;
  [[nodiscard]] constexpr bool plausible() const {
    return drop >= 0 && drop <= kMostDrop && lengths.plausible() && share >= 0 && share <= kOne;
  }
  template <class Word>
  constexpr void words(Word&& word) {
    word(drop);
    word(lengths.mantissa);
    word(lengths.shift);
    word(share);
  }

  /// exp(-x/l), Q28.
  /// @pre the travel is not negative
  [[nodiscard]] constexpr std::int32_t left(std::int64_t travel) const {
    // Beyond 2^31 steps, 64 lengths or more, nothing is left.
    const std::int64_t steps = std::min(travel >> drop, std::int64_t{kInt32Max});
    return exp2_factor(-lengths.times(static_cast<std::int32_t>(steps)));
  }
};

/// Wear or run-in of the sheath: mu (1 + a (n/1000)^p), or mu (1 + a exp(-n/n0)) where p is 0.
struct FrictionWear {
  std::int32_t log2_size = 0;  ///< log2 |a|, Q21, to 8
  std::int32_t lowers = 0;     ///< 1 where a is negative
  std::int32_t exponent = 0;   ///< p, Q28, 0 .. 2
  std::int32_t fading = 0;     ///< log2(e) / (2 n0) for each half cycle, Q31, where p is 0

  [[nodiscard]] constexpr bool plausible() const {
    return log2_size >= -(64 << kExponentBits) && log2_size <= kMostLog2Size &&
           (lowers & ~1) == 0 && exponent >= 0 && exponent <= 2 * kOne && fading >= 0 &&
           (exponent == 0) == (fading != 0);
  }
  template <class Word>
  constexpr void words(Word&& word) {
    word(log2_size);
    word(lowers);
    word(exponent);
    word(fading);
  }

  /// The factor of mu after so many half cycles, Q28.
  [[nodiscard]] constexpr std::int32_t factor(std::uint32_t half_cycles) const {
    const std::int64_t size = exp2_factor(log2_size + log2_growth(half_cycles));
    return factor_of(lowers != 0 ? -size : size);
  }

 private:
  static constexpr std::int32_t kMostLog2Size = 3 << kExponentBits;

  /// Q21.
  [[nodiscard]] constexpr std::int64_t log2_growth(std::uint32_t half_cycles) const {
    constexpr std::int64_t kNothing = -(std::int64_t{1} << 40);
    if (exponent == 0) {
      return -static_cast<std::int64_t>(
          (std::uint64_t{half_cycles} * static_cast<std::uint32_t>(fading)) >>
          (31 - kExponentBits));
    }
    if (half_cycles == 0) {
      return kNothing;
    }
    constexpr std::int32_t kLog2HalfCyclesOfReference = 735901326;  // log2 of 2000, Q26
    const std::int64_t log2_ratio = std::int64_t{log2_of(half_cycles)} - kLog2HalfCyclesOfReference;
    return rounded(log2_ratio * exponent, numeric::kLogBits + kFactorBits - kExponentBits);
  }
};

}  // namespace lifemodel::extension
