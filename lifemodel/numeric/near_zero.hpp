#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "lifemodel/numeric/logarithm.hpp"
#include "lifemodel/numeric/quotient.hpp"

/// Logarithms and powers of numbers near one that keep their relative accuracy: their results are
/// close to zero and would be the difference of two numbers that are almost equal.
namespace lifemodel::numeric {

/// `value` * 2^exponent rounded down to 27 significant bits.
/// @pre value > 0
constexpr Normal normal(std::uint64_t value, std::int32_t exponent) {
  const int shift = std::countl_zero(value);
  return {static_cast<std::uint32_t>((value << shift) >> 37), exponent + 63 - shift};
}

constexpr Normal product(Normal a, Normal b) {
  return normal(std::uint64_t{a.mantissa} * b.mantissa,
                a.exponent + b.exponent - 2 * kMantissaBits);
}

constexpr Normal quotient(Normal a, Normal b) {
  const Normal q = quotient(a.mantissa, b.mantissa);
  return {q.mantissa, q.exponent + a.exponent - b.exponent};
}

/// `x` with this many fraction bits, rounded down.
/// @pre it fits
constexpr std::uint64_t fixed(Normal x, int fraction_bits) {
  const std::int32_t shift = x.exponent + fraction_bits - kMantissaBits;
  if (shift >= 0) {
    return std::uint64_t{x.mantissa} << shift;
  }
  return shift > -32 ? x.mantissa >> -shift : 0;
}

/// 2^(log2 / 2^26); relative error at most 3e-8.
constexpr Normal exp2(std::int64_t log2) {
  constexpr int kStepBits = kLogBits - kSegmentBits;
  const auto fraction = static_cast<std::uint32_t>(log2) & ((1u << kLogBits) - 1);
  const auto t =
      static_cast<std::int32_t>((fraction & ((1u << kStepBits) - 1)) << (31 - kStepBits));
  return {evaluate(kExp2Segments[fraction >> kStepBits], t) >> (31 - kMantissaBits),
          static_cast<std::int32_t>(log2 >> kLogBits)};
}

inline constexpr Normal kLog2E{96817625, 0};  ///< 1.442695
inline constexpr Normal kLn2{93032639, -1};   ///< 0.693147

/// The power series of `coefficients` in Q30, lowest first, at |t| < 1/8 in Q31. Result in Q30.
template <std::size_t kTerms>
constexpr std::int32_t power_series(const std::array<std::int32_t, kTerms>& coefficients,
                                    std::int32_t t) {
  std::int32_t sum = 0;
  for (std::size_t i = kTerms; i-- > 0;) {
    sum = coefficients[i] + static_cast<std::int32_t>((std::int64_t{sum} * t) >> 31);
  }
  return sum;
}

/// ln(1 + t) / t in Q30 for |t| <= 1/16 in Q31; error at most 1e-8.
constexpr std::int32_t log1p_over(std::int32_t t) {
  // (-1)^n / (n + 1)
  constexpr std::array<std::int32_t, 6> kLog{1073741824, -536870912, 357913941,
                                             -268435456, 214748365,  -178956971};
  return power_series(kLog, t);
}

/// log2(1 + x); relative error at most 1.5e-6.
/// @pre x > 0
constexpr Normal log2_of_one_plus(Normal x) {
  if (x.exponent < -4) {
    const auto t = static_cast<std::int32_t>(fixed(x, 31));
    const auto over = static_cast<std::uint32_t>(log1p_over(t));
    return product(product(x, kLog2E), normal(over, -30));
  }
  // From 2^32 on the one is lost in the rounding.
  constexpr int kFraction = 30;
  const Normal sum = x.exponent < 32
                         ? normal(fixed(x, kFraction) + (std::uint64_t{1} << kFraction), -kFraction)
                         : x;
  const std::uint64_t log2 =
      (static_cast<std::uint64_t>(sum.exponent) << kLogBits) + log2_mantissa(sum.mantissa);
  return normal(log2, -kLogBits);
}

/// 1 - 2^-x; relative error at most 3e-7 and that of x.
/// @pre x > 0
constexpr Normal one_minus_exp2_of_minus(Normal x) {
  if (x.exponent < -3) {
    // (1 - e^-v) / v = 1 - v/2 + v^2/6 - ... with v = x ln 2 below 0.087
    constexpr std::array<std::int32_t, 6> kExp{1073741824, -536870912, 178956971,
                                               -44739243,  8947849,    -1491308};
    const Normal v = product(x, kLn2);
    const auto over =
        static_cast<std::uint32_t>(power_series(kExp, static_cast<std::int32_t>(fixed(v, 31))));
    return product(v, normal(over, -30));
  }
  constexpr Normal kOne{1u << kMantissaBits, 0};
  if (x.exponent > 4) {
    return kOne;
  }
  const Normal power = exp2(-static_cast<std::int64_t>(fixed(x, kLogBits)));
  constexpr int kFraction = 31;
  return normal((std::uint64_t{1} << kFraction) - fixed(power, kFraction), -kFraction);
}

}  // namespace lifemodel::numeric
