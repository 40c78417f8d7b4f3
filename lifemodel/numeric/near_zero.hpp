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
constexpr Normal normal(std::uint32_t value, std::int32_t exponent) {
  const int shift = std::countl_zero(value);
  return {(value << shift) >> (31 - kMantissaBits), exponent + 31 - shift};
}

constexpr Normal product(Normal a, Normal b) {
  const auto wide =
      static_cast<std::uint32_t>((std::uint64_t{a.mantissa} * b.mantissa) >> kMantissaBits);
  const std::uint32_t drop = wide >> (kMantissaBits + 1);
  return {wide >> drop, a.exponent + b.exponent + static_cast<std::int32_t>(drop)};
}

constexpr Normal quotient(Normal a, Normal b) {
  const Normal q = quotient(a.mantissa, b.mantissa);
  return {q.mantissa, q.exponent + a.exponent - b.exponent};
}

/// `x` with this many fraction bits, rounded down.
/// @pre x < 2^(32 - fraction_bits)
constexpr std::uint32_t fixed(Normal x, int fraction_bits) {
  const std::int32_t shift = x.exponent + fraction_bits - kMantissaBits;
  if (shift >= 0) {
    return x.mantissa << shift;
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

/// The coefficients of a power series in Q30, lowest first.
using PowerSeries = std::array<std::int32_t, 6>;

/// ln(1 + t) / t = 1 - t/2 + t^2/3 - ...
inline constexpr PowerSeries kLogSeries{1073741824, -536870912, 357913941,
                                        -268435456, 214748365,  -178956971};
/// (1 - e^-t) / t = 1 - t/2! + t^2/3! - ...
inline constexpr PowerSeries kExpSeries{1073741824, -536870912, 178956971,
                                        -44739243,  8947849,    -1491308};

/// A series at |t| <= 1/8 in Q31, result in Q30; error at most 1e-8 for |t| <= 1/16.
constexpr std::uint32_t at(const PowerSeries& series, std::int32_t t) {
  std::int32_t sum = 0;
  for (std::size_t i = series.size(); i-- > 0;) {
    sum = series[i] + static_cast<std::int32_t>((std::int64_t{sum} * t) >> 31);
  }
  return static_cast<std::uint32_t>(sum);
}

/// log2(1 + x); relative error at most 1.5e-6.
/// @pre 0 < x < 2^63
constexpr Normal log2_of_one_plus(Normal x) {
  if (x.exponent < -4) {
    const auto t = static_cast<std::int32_t>(fixed(x, 31));
    return product(product(x, kLog2E), normal(at(kLogSeries, t), -30));
  }
  constexpr std::uint32_t kOne = 1u << kMantissaBits;
  std::uint32_t sum = x.mantissa;
  std::int32_t exponent = x.exponent;
  if (exponent < 0) {
    sum = kOne + (x.mantissa >> -exponent);
    exponent = 0;
  } else if (exponent <= kMantissaBits) {
    sum += kOne >> exponent;
    const std::uint32_t drop = sum >> (kMantissaBits + 1);
    sum >>= drop;
    exponent += static_cast<std::int32_t>(drop);
  }
  return normal((static_cast<std::uint32_t>(exponent) << kLogBits) + log2_mantissa(sum), -kLogBits);
}

/// 1 - 2^-x; relative error at most 3e-7 and that of x.
/// @pre x > 0
constexpr Normal one_minus_exp2_of_minus(Normal x) {
  if (x.exponent < -3) {
    const Normal v = product(x, kLn2);
    return product(v, normal(at(kExpSeries, static_cast<std::int32_t>(fixed(v, 31))), -30));
  }
  constexpr Normal kOne{1u << kMantissaBits, 0};
  if (x.exponent > 4) {
    return kOne;
  }
  const Normal power = exp2(-static_cast<std::int64_t>(fixed(x, kLogBits)));
  constexpr int kFraction = 31;
  return normal((1u << kFraction) - fixed(power, kFraction), -kFraction);
}

}  // namespace lifemodel::numeric
