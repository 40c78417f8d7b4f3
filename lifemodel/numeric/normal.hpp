#pragma once

#include <cstdint>

namespace lifemodel::numeric {

/// A positive number rounded down to 27 significant bits: mantissa / 2^26 * 2^exponent, with
/// 2^26 <= mantissa < 2^27. Rounding down to a grid that depends on the value alone keeps order.
struct Normal {
  std::uint32_t mantissa;
  std::int32_t exponent;
};

inline constexpr int kMantissaBits = 26;

}  // namespace lifemodel::numeric
