#pragma once

#include <cstdint>

#include "lifemodel/damage/damage.hpp"
#include "lifemodel/numeric/exp2.hpp"
#include "lifemodel/numeric/log2.hpp"
#include "lifemodel/numeric/quotient.hpp"
#include "lifemodel/quantity/units.hpp"

namespace lifemodel {

/// The damage of one cycle between two turning points: Gerber effective tension (11), inverse power
/// law (19), Miner's 1/alpha.
///
/// With turning points x, y and ultimate tension u the law is evaluated as
///   T_eff / u = 2 |x - y| u / ((2u - (x + y)) (2u + (x + y))),   d = (T_eff / u)^gamma / alpha(u).
/// The quotient is exact and the rest never falls as it grows, so widening a cycle never lowers its
/// damage by even one step. Relative error at most 2e-6 for gamma <= 12.
struct CycleLaw {
  UltimateTension ultimate;
  IplExponent exponent;
  std::int32_t log2_two_ultimate;        ///< log2 of 2u in steps of Tension, Q26
  std::int32_t log2_damage_at_ultimate;  ///< -log2 alpha(u), Q21

  /// A cycle that reaches the ultimate tension, and one whose life is below one cycle, uses up a
  /// whole life: the largest damage of a cycle. Precondition: x != y.
  [[nodiscard]] constexpr CycleDamage operator()(Tension x, Tension y) const {
    if (overloads(x) || overloads(y)) {
      return kWholeLife;
    }
    const auto sum = static_cast<std::uint32_t>(x.raw() + y.raw());
    const std::uint32_t two_ultimate = static_cast<std::uint32_t>(ultimate.raw()) * 2;
    const std::uint64_t denominator = std::uint64_t{two_ultimate - sum} * (two_ultimate + sum);
    const numeric::Normal ratio = numeric::quotient(distance(x, y).raw(), denominator);
    // Wraps on the way where the quotient is small; the sum itself is within -31 .. 1.
    const std::uint32_t log2_relative = (static_cast<std::uint32_t>(ratio.exponent) << 26) +
                                        numeric::log2_mantissa(ratio.mantissa) +
                                        static_cast<std::uint32_t>(log2_two_ultimate);
    const std::int64_t product = std::int64_t{static_cast<std::int32_t>(log2_relative)} *
                                 static_cast<std::int32_t>(exponent.raw());
    const std::int32_t log2_damage =
        static_cast<std::int32_t>(product >> 32) + log2_damage_at_ultimate;
    if (log2_damage >= 0) {
      return kWholeLife;
    }
    const auto fraction = static_cast<std::uint32_t>(log2_damage) & ((1u << numeric::kExpBits) - 1);
    return {numeric::exp2_fraction(fraction),
            (log2_damage >> numeric::kExpBits) + Damage::kFractionBits - 31};
  }

  [[nodiscard]] constexpr bool overloads(Tension t) const {
    return t.raw() >= ultimate.raw() || t.raw() <= -ultimate.raw();
  }
};

}  // namespace lifemodel
