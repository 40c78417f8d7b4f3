#pragma once

#include <compare>
#include <concepts>
#include <cstdint>
#include <limits>
#include <optional>

#include "lifemodel/quantity/flags.hpp"

namespace lifemodel {

/// Overflow policy of measured values: the nearest end of the closed range, and Flag::saturated.
struct SaturateFlagged {};
/// Overflow policy of parameters: a value outside the closed range does not exist.
struct Refuse {};

/// A fixed-point number `raw / 2^kFraction` in the unit `UnitT`, within [kLowest, kHighest] raw.
///
/// Quantities of different unit, Q-format, range or policy are different types: nothing converts
/// between them implicitly, and adding or comparing them does not compile.
template <class UnitT, class RepT, int kFraction, RepT kLowest, RepT kHighest, class OverflowT>
class Quantity {
  static_assert(sizeof(RepT) <= sizeof(std::int32_t), "arithmetic is done in 64 bits");
  static_assert(kLowest <= kHighest);

 public:
  using Rep = RepT;
  using Overflow = OverflowT;
  static constexpr int kFractionBits = kFraction;

  constexpr Quantity() = default;

  static constexpr Quantity lowest() { return Quantity(kLowest); }
  static constexpr Quantity highest() { return Quantity(kHighest); }

  /// The value with this raw representation, or nothing outside the closed range.
  static constexpr std::optional<Quantity> checked(std::int64_t raw) {
    if (raw < std::int64_t{kLowest} || raw > std::int64_t{kHighest}) {
      return std::nullopt;
    }
    return Quantity(static_cast<Rep>(raw));
  }

  /// The value nearest to this raw representation; raises Flag::saturated outside the range.
  static constexpr Quantity saturated(
      std::int64_t raw, Flags& flags) requires std::same_as<Overflow, SaturateFlagged> {
    if (raw < std::int64_t{kLowest}) {
      flags.raise(Flag::saturated);
      return lowest();
    }
    if (raw > std::int64_t{kHighest}) {
      flags.raise(Flag::saturated);
      return highest();
    }
    return Quantity(static_cast<Rep>(raw));
  }

  /// The value with this raw representation.
  /// @pre within the closed range
  static constexpr Quantity from_raw(Rep raw) { return Quantity(raw); }

  /// `thousandths` of a unit, to the nearest representable value. For up to 25 fraction bits.
  static constexpr Quantity from_milli(
      std::int32_t thousandths, Flags& flags) requires std::same_as<Overflow, SaturateFlagged> {
    // 1/1000 as 2^-42 * 4398046511 (error 2.5e-11), so that no 64-bit division is needed.
    constexpr std::uint64_t kThousandth = 4398046511u;
    const bool negative = thousandths < 0;
    const std::uint64_t magnitude = negative
                                        ? 0u - static_cast<std::uint64_t>(std::int64_t{thousandths})
                                        : static_cast<std::uint64_t>(std::int64_t{thousandths});
    const std::uint64_t low = (magnitude & 0xffffu) * kThousandth;
    const std::uint64_t high = (magnitude >> 16) * kThousandth;
    constexpr int kShift = 42 - kFraction;
    static_assert(kShift > 16);
    const std::uint64_t scaled =
        (high + (low >> 16) + (std::uint64_t{1} << (kShift - 17))) >> (kShift - 16);
    const auto raw = static_cast<std::int64_t>(scaled);
    return saturated(negative ? -raw : raw, flags);
  }

  [[nodiscard]] constexpr Rep raw() const { return raw_; }

  /// Sum, saturating.
  static constexpr Quantity sum(Quantity a, Quantity b,
                                Flags& flags) requires std::same_as<Overflow, SaturateFlagged> {
    return saturated(std::int64_t{a.raw_} + std::int64_t{b.raw_}, flags);
  }
  /// Difference, saturating.
  static constexpr Quantity difference(
      Quantity a, Quantity b, Flags& flags) requires std::same_as<Overflow, SaturateFlagged> {
    return saturated(std::int64_t{a.raw_} - std::int64_t{b.raw_}, flags);
  }

  friend constexpr auto operator<=>(Quantity, Quantity) = default;

 private:
  constexpr explicit Quantity(Rep raw) : raw_(raw) {}
  Rep raw_ = 0;
};

struct UltimateTension {};  ///< the tension at which the wire breaks is 1
struct Ampere {};
struct MetrePerSecond {};
struct Radian {};
struct One {};        ///< a ratio
struct PerRadian {};  ///< log2 of a tension ratio for each radian of bend

inline constexpr std::int32_t kInt32Max = std::numeric_limits<std::int32_t>::max();

/// Tension of the wire relative to its ultimate tension, Q2.29: the same relative resolution
/// of 1.9e-9 for every wire, closed range +-4 less one step.
using Tension = Quantity<UltimateTension, std::int32_t, 29, -kInt32Max, kInt32Max, SaturateFlagged>;

/// Distance of two tensions, Q3.29, 0 .. 8.
using TensionRange = Quantity<UltimateTension, std::uint32_t, 29, 0,
                              std::numeric_limits<std::uint32_t>::max(), Refuse>;

/// The tension at which the wire breaks.
inline constexpr Tension kUltimate = Tension::from_raw(1 << 29);

/// Motor current, Q7.24: resolution 60 nA, closed range +-128 A less one step.
using MotorCurrent = Quantity<Ampere, std::int32_t, 24, -kInt32Max, kInt32Max, SaturateFlagged>;

/// Velocity of the tendon, positive while pulling, Q7.24: resolution 60 nm/s, range +-128 m/s.
using Velocity = Quantity<MetrePerSecond, std::int32_t, 24, -kInt32Max, kInt32Max, SaturateFlagged>;

/// Bend angle of the sheath, Q5.26, 0 .. 31.5 rad (1800 deg).
using Angle = Quantity<Radian, std::int32_t, 26, 0, 63 << 25, SaturateFlagged>;

/// A probability or efficiency, Q1.30, 0 .. 1.
using Ratio = Quantity<One, std::uint32_t, 30, 0, 1u << 30, SaturateFlagged>;

/// mu * log2(e), Q1.30, for friction coefficients 0 .. 1.
using FrictionExponent = Quantity<PerRadian, std::uint32_t, 30, 0, 1549082005u, Refuse>;

/// Exponent gamma of the inverse power law (19), Q5.27, 1 .. 12.
using IplExponent = Quantity<One, std::uint32_t, 27, 1u << 27, 12u << 27, Refuse>;

/// Weibull shape beta (15), Q7.25, 0.5 .. 50.
using WeibullShape = Quantity<One, std::uint32_t, 25, 1u << 24, 50u << 25, Refuse>;

/// Distance of two tensions; exact, whatever their signs.
constexpr TensionRange distance(Tension a, Tension b) {
  const auto ua = static_cast<std::uint32_t>(a.raw());
  const auto ub = static_cast<std::uint32_t>(b.raw());
  return TensionRange::from_raw(a.raw() >= b.raw() ? ua - ub : ub - ua);
}

/// A count of events of kind `WhatT`. Stops at its highest value and raises Flag::saturated.
template <class WhatT, std::unsigned_integral RepT>
class Count {
 public:
  using Rep = RepT;

  constexpr Count() = default;
  static constexpr Count from_raw(Rep raw) { return Count(raw); }
  [[nodiscard]] constexpr Rep raw() const { return raw_; }

  constexpr void add(Rep n, Flags& flags) {
    if (__builtin_add_overflow(raw_, n, &raw_)) [[unlikely]] {
      raw_ = std::numeric_limits<Rep>::max();
      flags.raise(Flag::saturated);
    }
  }

  friend constexpr auto operator<=>(Count, Count) = default;

 private:
  constexpr explicit Count(Rep raw) : raw_(raw) {}
  Rep raw_ = 0;
};

struct Cycle {};
struct HalfCycle {};
struct MissingSample {};
struct Event {};

using Cycles = Count<Cycle, std::uint64_t>;
using HalfCycles = Count<HalfCycle, std::uint64_t>;
using MissingSamples = Count<MissingSample, std::uint32_t>;
using Events = Count<Event, std::uint32_t>;

}  // namespace lifemodel
