#pragma once

#include <cstdint>

namespace lifemodel {

/// How sure the fit of a life law is of its numbers: half of the widths of their 95 % intervals.
/// All zero where nobody has said. Scale and exponent of the law lean on each other; the
/// characteristic life at the pivot and the exponent do not, so the half-width of log2 alpha at
/// another damage d of a cycle is the root of log2_life^2 and (exponent * (log2 d - pivot) /
/// gamma)^2.
struct LifeUncertainty {
  static constexpr std::uint32_t kWidestLog2Life = 64u << 21;
  static constexpr std::uint32_t kWidestExponent = 12u << 27;
  static constexpr std::uint32_t kWidestLog2Shape = 8u << 21;

  std::uint32_t log2_life = 0;            ///< of log2 of the characteristic life at the pivot, Q21
  std::uint32_t exponent = 0;             ///< of gamma of (19), Q27 as IplExponent
  std::uint32_t log2_shape = 0;           ///< of log2 of the Weibull shape, Q21
  std::int32_t log2_damage_at_pivot = 0;  ///< log2 of the damage of one cycle there, Q21

  [[nodiscard]] constexpr bool known() const { return *this != LifeUncertainty{}; }

  friend constexpr bool operator==(const LifeUncertainty&, const LifeUncertainty&) = default;
};

}  // namespace lifemodel
