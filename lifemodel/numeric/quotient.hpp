#pragma once

#include <bit>
#include <cstdint>

namespace lifemodel::numeric {

/// A positive number rounded down to 27 significant bits: mantissa / 2^26 * 2^exponent, with
/// 2^26 <= mantissa < 2^27. Rounding down to a grid that depends on the value alone keeps order.
struct Normal {
  std::uint32_t mantissa;
  std::int32_t exponent;
};

inline constexpr int kMantissaBits = 26;

/// floor(numerator / denominator) to 27 significant bits, exact in every case. Because it is exact,
/// a larger quotient never gives a smaller result, which the damage of a cycle relies on.
///
/// Needs one 32-bit division; no 64-bit division, no loop.
/// @pre both are positive
constexpr Normal quotient(std::uint32_t numerator, std::uint64_t denominator) {
  const int numerator_shift = std::countl_zero(numerator);
  const int denominator_shift = std::countl_zero(denominator);
  const std::uint32_t n = numerator << numerator_shift;
  const std::uint64_t d = denominator << denominator_shift;
  const auto d_high = static_cast<std::uint32_t>(d >> 32);
  const auto d_low = static_cast<std::uint32_t>(d);

  // Reciprocal of d_high + 1 by a 16-bit seed and one Newton step; never too large. With the seed's
  // relative error below 1.5 * 2^-15 the estimate below is at most one too small.
  const std::uint32_t seed = 0xffffffffu / ((d_high >> 16) + 1u);
  const std::uint64_t product = std::uint64_t{seed} * d_high + seed;
  const auto correction = static_cast<std::uint32_t>(((std::uint64_t{1} << 49) - product) >> 17);
  const auto reciprocal = static_cast<std::uint32_t>((std::uint64_t{seed} * correction) >> 16);

  // quotient = floor(n * 2^59 / d) is in [2^26, 2^28).
  std::uint32_t q = static_cast<std::uint32_t>((std::uint64_t{n} * reciprocal) >> 32) >> 4;
  const std::uint64_t low = std::uint64_t{q + 1} * d_low;
  const std::uint64_t next =
      std::uint64_t{q + 1} * d_high + (low >> 32) + (static_cast<std::uint32_t>(low) != 0 ? 1 : 0);
  if (next <= std::uint64_t{n} << 27) {
    ++q;
  }
  const std::uint32_t wide = q >> (kMantissaBits + 1);
  return {q >> wide, denominator_shift - numerator_shift - 33 + static_cast<std::int32_t>(wide)};
}

}  // namespace lifemodel::numeric
