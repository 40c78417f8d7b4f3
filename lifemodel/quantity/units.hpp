#pragma once

#include <cstdint>
#include <limits>

#include "lifemodel/quantity/quantity.hpp"

namespace lifemodel {

struct UltimateTension {};  ///< the tension at which the wire breaks is 1
struct Ampere {};
struct Radian {};
struct One {};        ///< a ratio
struct PerRadian {};  ///< log2 of a tension ratio for each radian of bend
struct Binary {};     ///< a logarithm to base 2

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

}  // namespace lifemodel
