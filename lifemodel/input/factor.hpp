#pragma once

#include <cstdint>

namespace lifemodel {

/// A factor of two fixed-point formats: mantissa * 2^-shift, mantissa 2^30 .. 2^31 - 1.
struct Factor {
  std::int32_t mantissa;
  std::int32_t shift;

  static constexpr std::int32_t kLowestShift = 1;
  static constexpr std::int32_t kHighestShift = 62;
  [[nodiscard]] constexpr bool plausible() const {
    return mantissa >= (1 << 30) && shift >= kLowestShift && shift <= kHighestShift;
  }
  /// The product, to the nearest step.
  [[nodiscard]] constexpr std::int64_t times(std::int32_t value) const {
    const std::int64_t rounding = std::int64_t{1} << (shift - 1);
    return (std::int64_t{value} * mantissa + rounding) >> shift;
  }
};

}  // namespace lifemodel
