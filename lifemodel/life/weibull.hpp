#pragma once

#include <bit>
#include <cstdint>
#include <limits>

#include "lifemodel/damage/damage.hpp"
#include "lifemodel/numeric/logarithm.hpp"
#include "lifemodel/numeric/quotient.hpp"
#include "lifemodel/quantity/units.hpp"

namespace lifemodel {

/// A level of damage at which a stated part of all wires has broken, Q4.28.
struct LifePoint {
  std::uint32_t raw;
  static constexpr int kFractionBits = 28;

  [[nodiscard]] constexpr Damage damage() const {
    Damage result;
    Flags none;
    if (raw != 0) {
      const int shift = std::countl_zero(raw);
      result.add({raw << shift, Damage::kFractionBits - kFractionBits - shift}, none);
    }
    return result;
  }
};

/// A damage rounded down to 27 significant bits.
/// @pre damage > 0
constexpr numeric::Normal normalise(const Damage& damage) {
  const Damage::Words& words = damage.words();
  std::size_t top = words.size() - 1;
  while (top > 0 && words[top] == 0) {
    --top;
  }
  const std::uint64_t window = (std::uint64_t{words[top]} << 32) | (top > 0 ? words[top - 1] : 0u);
  const int shift = std::countl_zero(window);
  return {static_cast<std::uint32_t>((window << shift) >> 37),
          static_cast<std::int32_t>(top) * 32 + 31 - shift - Damage::kFractionBits};
}

/// The life distribution over Miner damage: R = exp(-D^beta), eqs (15), (20), (22).
struct LifeDistribution {
  WeibullShape shape;
  LifePoint b10;  ///< 10 % of wires have broken
  LifePoint b50;
  LifePoint mean;  ///< Gamma(1 + 1/beta), eq (21)
  LifePoint b90;

  /// The probability that a wire with this damage is still whole; absolute error at most 4e-6.
  [[nodiscard]] constexpr Ratio survival(const Damage& damage) const {
    if (damage == Damage{}) {
      return Ratio::highest();
    }
    const numeric::Normal d = normalise(damage);
    // log2 of y = D^beta in Q21, then R = 2^-(y log2 e).
    const std::int64_t log2_damage =
        (std::int64_t{d.exponent} << numeric::kLogBits) + numeric::log2_mantissa(d.mantissa);
    constexpr int kDrop = WeibullShape::kFractionBits + numeric::kLogBits - numeric::kExpBits;
    const std::int64_t log2_y = (log2_damage * shape.raw()) >> kDrop;
    constexpr std::int64_t kLog2Log2E = 1108903;  // log2(log2 e) in Q21
    const std::int64_t log2_exponent = log2_y + kLog2Log2E;
    constexpr std::int64_t kOne = std::int64_t{1} << numeric::kExpBits;
    if (log2_exponent >= 6 * kOne) {
      return Ratio::lowest();
    }
    if (log2_exponent < -31 * kOne) {
      return Ratio::highest();
    }
    const std::uint32_t mantissa = numeric::exp2_fraction(
        static_cast<std::uint32_t>(log2_exponent) & ((1u << numeric::kExpBits) - 1));
    const auto whole = static_cast<std::int32_t>(log2_exponent >> numeric::kExpBits);
    // The exponent y log2 e in Q21, rounded down: 0 .. 64.
    const auto exponent = static_cast<std::uint32_t>(
        whole >= 0 ? (std::uint64_t{mantissa} << whole) >> (31 - numeric::kExpBits)
                   : std::uint64_t{mantissa} >> (31 - numeric::kExpBits - whole));
    const std::uint32_t negative = 0u - exponent;
    const std::uint32_t fraction = negative & ((1u << numeric::kExpBits) - 1);
    const std::uint32_t shift = (exponent + fraction) >> numeric::kExpBits;
    return Ratio::from_raw(shift > 31 ? 0 : (numeric::exp2_fraction(fraction) >> shift) >> 1);
  }
};

/// How often a profile that does `each` damage can be repeated from `used` until `end`: rounded
/// down, relative error at most 4e-7; saturates at 2^32 - 1, also where the profile does no damage.
constexpr std::uint32_t remaining_repeats(const Damage& used, const Damage& each, LifePoint end) {
  const Damage limit = end.damage();
  if (used >= limit) {
    return 0;
  }
  if (each == Damage{}) {
    return std::numeric_limits<std::uint32_t>::max();
  }
  const numeric::Normal remaining = normalise(Damage::difference(limit, used));
  const numeric::Normal one = normalise(each);
  const numeric::Normal q = numeric::quotient(remaining.mantissa, one.mantissa);
  const std::int32_t exponent = q.exponent + remaining.exponent - one.exponent;
  if (exponent >= 32) {
    return std::numeric_limits<std::uint32_t>::max();
  }
  if (exponent < 0) {
    return 0;
  }
  return exponent > numeric::kMantissaBits ? q.mantissa << (exponent - numeric::kMantissaBits)
                                           : q.mantissa >> (numeric::kMantissaBits - exponent);
}

}  // namespace lifemodel
