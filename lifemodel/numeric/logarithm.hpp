#pragma once

#include <cstdint>

#include "lifemodel/numeric/quotient.hpp"
#include "lifemodel/numeric/tables.hpp"

namespace lifemodel::numeric {

inline constexpr int kSegmentBits = 4;

constexpr std::int32_t multiply_high(std::int32_t a, std::int32_t b) {
  return static_cast<std::int32_t>((std::int64_t{a} * b) >> 32);
}

/// The segment at `t` in Q31, result in Q31.
constexpr std::uint32_t evaluate(const Segment& s, std::int32_t t) {
  const std::int32_t slope = s.c1 + multiply_high(t, s.c2 + multiply_high(t, s.c3));
  return s.c0 + static_cast<std::uint32_t>(multiply_high(t, slope));
}

/// Fraction bits of an exponent.
inline constexpr int kExpBits = 21;

/// Largest relative error of exp2_fraction(): checked for every fraction.
inline constexpr double kExp2MaxRelativeError = 6.0e-9;

/// 2^(fraction / 2^21) in Q31 for 0 <= fraction < 2^21: 2^31 .. 2^32 - 1. Grows with the fraction;
/// relative error at most kExp2MaxRelativeError.
constexpr std::uint32_t exp2_fraction(std::uint32_t fraction) {
  constexpr int kStepBits = kExpBits - kSegmentBits;
  const auto t =
      static_cast<std::int32_t>((fraction & ((1u << kStepBits) - 1)) << (31 - kStepBits));
  return evaluate(kExp2Segments[fraction >> kStepBits], t);
}

/// Fraction bits of a base-2 logarithm.
inline constexpr int kLogBits = 26;

/// Largest error of log2_mantissa(), in units of the logarithm: checked for every mantissa.
inline constexpr double kLog2MaxError = 9.0e-8;

/// log2(mantissa / 2^26) in Q26 for 2^26 <= mantissa < 2^27: 0 .. 2^26 - 1. Never falls as the
/// mantissa grows; error at most kLog2MaxError.
constexpr std::uint32_t log2_mantissa(std::uint32_t mantissa) {
  constexpr int kStepBits = kMantissaBits - kSegmentBits;
  const std::uint32_t fraction = mantissa - (1u << kMantissaBits);
  const auto t =
      static_cast<std::int32_t>((fraction & ((1u << kStepBits) - 1)) << (31 - kStepBits));
  return evaluate(kLog2Segments[fraction >> kStepBits], t) >> (31 - kLogBits);
}

/// log2 of a normal number in Q26. Range of exponents: -31 .. 30, wider ones wrap.
constexpr std::int32_t log2(Normal x) {
  return static_cast<std::int32_t>((static_cast<std::uint32_t>(x.exponent) << kLogBits) +
                                   log2_mantissa(x.mantissa));
}

}  // namespace lifemodel::numeric
