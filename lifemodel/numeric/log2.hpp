#pragma once

#include <cstdint>

#include "lifemodel/numeric/cubic.hpp"
#include "lifemodel/numeric/normal.hpp"
#include "lifemodel/numeric/tables.hpp"

namespace lifemodel::numeric {

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
