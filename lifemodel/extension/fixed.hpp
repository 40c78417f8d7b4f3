#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include "lifemodel/numeric/logarithm.hpp"

/// Arithmetic that the effects share.
namespace lifemodel::extension {

/// A value / 2^bits, to the nearest.
constexpr std::int64_t rounded(std::int64_t value, int bits) {
  return (value + (std::int64_t{1} << (bits - 1))) >> bits;
}

constexpr std::int32_t held(std::int64_t value, std::int32_t lowest, std::int32_t highest) {
  return static_cast<std::int32_t>(std::clamp(value, std::int64_t{lowest}, std::int64_t{highest}));
}

/// Factors, Q28.
inline constexpr int kFactorBits = 28;
inline constexpr std::int32_t kOne = 1 << kFactorBits;
/// A factor is held in 0 .. 7.
inline constexpr std::int32_t kMostFactor = 7 * kOne;

/// 1 + change, held in 0 .. 7.
constexpr std::int32_t factor_of(std::int64_t change) {
  return held(kOne + std::clamp(change, -std::int64_t{kMostFactor}, std::int64_t{kMostFactor}), 0,
              kMostFactor);
}

/// Fractional bits of exponents to base 2.
inline constexpr int kExponentBits = numeric::kExpBits;

/// 2^exponent in Q28, exponent in Q21; at most 7.
constexpr std::int32_t exp2_factor(std::int64_t exponent) {
  if (exponent >= 3 * (std::int64_t{1} << kExponentBits)) {
    return kMostFactor;
  }
  if (exponent < -29 * (std::int64_t{1} << kExponentBits)) {
    return 0;
  }
  const auto narrow = static_cast<std::int32_t>(exponent);
  const std::uint32_t fraction =
      numeric::exp2_fraction(static_cast<std::uint32_t>(narrow) & ((1u << kExponentBits) - 1));
  // The fraction is in Q31: 1 .. 2.
  const int drop = 3 - (narrow >> kExponentBits);
  return held(rounded(fraction, drop), 0, kMostFactor);
}

/// log2 of a value in Q26.
/// @pre above 0
constexpr std::int32_t log2_of(std::uint32_t value) {
  const int shift = std::countl_zero(value);
  return numeric::log2({(value << shift) >> 5, 31 - shift});
}

/// share * of + (1 - share) * other; each part is rounded down, which keeps order.
constexpr std::int32_t weighted(std::int32_t share, std::int32_t of, std::int32_t other) {
  return static_cast<std::int32_t>((std::int64_t{of} * share) >> kFactorBits) +
         static_cast<std::int32_t>((std::int64_t{other} * (kOne - share)) >> kFactorBits);
}

/// log2 of an effective tension that does no damage, Q26.
inline constexpr std::int32_t kNoDamage = -(30 << numeric::kLogBits);

}  // namespace lifemodel::extension
