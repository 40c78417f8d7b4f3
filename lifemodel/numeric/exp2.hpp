#pragma once

#include <cstdint>

#include "lifemodel/numeric/cubic.hpp"
#include "lifemodel/numeric/tables.hpp"

namespace lifemodel::numeric {

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

}  // namespace lifemodel::numeric
