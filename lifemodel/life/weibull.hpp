#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <tuple>

#include "lifemodel/damage/damage.hpp"
#include "lifemodel/numeric/logarithm.hpp"
#include "lifemodel/numeric/near_zero.hpp"
#include "lifemodel/numeric/quotient.hpp"
#include "lifemodel/quantity/units.hpp"
#include "lifemodel/support/inlining.hpp"

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
  const int shift = std::countl_zero(words[top]);
  const std::uint64_t bits = (std::uint64_t{words[top]} << 32) | (top > 0 ? words[top - 1] : 0);
  return {static_cast<std::uint32_t>((bits << shift) >> (63 - numeric::kMantissaBits)),
          static_cast<std::int32_t>(top) * 32 + 31 - shift - Damage::kFractionBits};
}

/// The damage of a number, rounded down to 2^-104; saturates.
constexpr Damage denormalise(numeric::Normal value) {
  constexpr int kBits = 32 * static_cast<int>(std::tuple_size_v<Damage::Words>);
  constexpr int kUp = 31 - numeric::kMantissaBits;
  const std::int32_t position = value.exponent - 31 + Damage::kFractionBits;
  Damage result;
  Flags none;
  if (position >= kBits) {
    return Damage::highest();
  }
  if (position > -32) {
    result.add({value.mantissa << kUp, position}, none);
  }
  return result;
}

/// log2 of damage^shape in Q26, rounded down but for the error of the logarithm. In two parts,
/// because the whole has more than 63 bits for small damages and large shapes.
/// @pre -2^26 < exponent < 2^26
constexpr std::int64_t log2_power(numeric::Normal damage, WeibullShape shape) {
  const std::int64_t whole = std::int64_t{damage.exponent} * shape.raw();
  const std::uint64_t fraction =
      std::uint64_t{numeric::log2_mantissa(damage.mantissa)} * shape.raw();
  constexpr int kDrop = WeibullShape::kFractionBits;
  return (whole << (numeric::kLogBits - kDrop)) + static_cast<std::int64_t>(fraction >> kDrop);
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
    if (damage.none()) {
      return Ratio::highest();
    }
    // y = D^beta, then R = 2^-(y log2 e), from here on in Q21.
    const std::int64_t log2_y =
        log2_power(normalise(damage), shape) >> (numeric::kLogBits - numeric::kExpBits);
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

/// How often a stretch that does `each` damage fits into what is left: rounded down, relative error
/// at most 4e-7; saturates at 2^32 - 1, also where the stretch does no damage.
LIFEMODEL_ONE_COPY constexpr std::uint32_t repeats_within(const Damage& left, const Damage& each) {
  if (left.none()) {
    return 0;
  }
  if (each.none()) {
    return std::numeric_limits<std::uint32_t>::max();
  }
  const numeric::Normal q = numeric::quotient(normalise(left), normalise(each));
  if (q.exponent >= 32) {
    return std::numeric_limits<std::uint32_t>::max();
  }
  return q.exponent < 0 ? 0 : numeric::fixed(q, 0);
}

/// How often a stretch that does `each` damage can be repeated from `used` until `end`, a point of
/// the whole life of a new wire; see repeats_within().
constexpr std::uint32_t remaining_repeats(const Damage& used, const Damage& each, LifePoint end) {
  const Damage limit = end.damage();
  return used >= limit ? 0 : repeats_within(Damage::difference(limit, used), each);
}

}  // namespace lifemodel
