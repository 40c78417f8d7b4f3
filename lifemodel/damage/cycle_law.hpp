#pragma once

#include <cstdint>

#include "lifemodel/damage/damage.hpp"
#include "lifemodel/numeric/logarithm.hpp"
#include "lifemodel/numeric/quotient.hpp"
#include "lifemodel/quantity/units.hpp"
#include "lifemodel/support/inlining.hpp"

namespace lifemodel {

/// The damage of one cycle between two turning points: Gerber effective tension (11), inverse power
/// law (19), Miner's 1/alpha.
///
/// With turning points x, y relative to the ultimate tension the law is evaluated as
///   T_eff = 2 |x - y| / ((2 - (x + y)) (2 + (x + y))),   d = T_eff^gamma / alpha(1).
/// The quotient is exact and the rest never falls as it grows, so widening a cycle never lowers its
/// damage by even one step. Relative error at most 2e-6 for gamma <= 12.
struct CycleLaw {
  IplExponent exponent;
  std::int32_t log2_damage_at_ultimate;  ///< -log2 alpha at the ultimate tension, Q21

  /// A cycle that reaches the ultimate tension, and one whose life is below one cycle, uses up a
  /// whole life: the largest damage of a cycle.
  /// @pre x != y
  [[nodiscard]] constexpr CycleDamage operator()(Tension x, Tension y) const {
    return CycleDamage::unpack(packed_if_below(x, y));
  }

  /// The same where neither is known to reach the ultimate tension.
  [[nodiscard]] constexpr CycleDamage below_ultimate(Tension x, Tension y) const {
    return CycleDamage::unpack(packed(x, y));
  }

  static constexpr bool overloads(Tension t) {
    return t.raw() >= kUltimate.raw() || t.raw() <= -kUltimate.raw();
  }

  /// log2 T_eff of a cycle relative to the ultimate tension, Q26, at least -30.
  /// @pre x != y, neither reaches the ultimate tension
  static constexpr std::int32_t log2_effective(Tension x, Tension y) {
    const auto sum = static_cast<std::uint32_t>(x.raw() + y.raw());
    constexpr std::uint32_t kTwo = 2u << Tension::kFractionBits;
    const std::uint64_t denominator = std::uint64_t{kTwo - sum} * (kTwo + sum);
    const numeric::Normal ratio = numeric::quotient(distance(x, y).raw(), denominator);
    // The exponent takes in 2 * 2^29.
    constexpr std::int32_t kScale = Tension::kFractionBits + 1;
    return numeric::log2({ratio.mantissa, ratio.exponent + kScale});
  }

  /// CycleDamage::pack() of the damage at an effective tension.
  [[nodiscard]] constexpr std::uint64_t packed_damage(std::int32_t log2_effective_tension) const {
    const std::int64_t product =
        std::int64_t{log2_effective_tension} * static_cast<std::int32_t>(exponent.raw());
    const std::int32_t log2_damage =
        static_cast<std::int32_t>(product >> 32) + log2_damage_at_ultimate;
    if (log2_damage >= 0) {
      return kWholeLife.pack();
    }
    constexpr std::int32_t kLowest = (1 - Damage::kFractionBits) << numeric::kExpBits;
    if (log2_damage < kLowest) [[unlikely]] {
      return kSmallestCycle.pack();
    }
    const auto fraction = static_cast<std::uint32_t>(log2_damage) & ((1u << numeric::kExpBits) - 1);
    return CycleDamage{numeric::exp2_fraction(fraction),
                       (log2_damage >> numeric::kExpBits) + Damage::kFractionBits - 31}
        .pack();
  }

 private:
  // Packed into a word pair, which comes back in registers.
  [[nodiscard]] LIFEMODEL_ONE_COPY constexpr std::uint64_t packed_if_below(Tension x,
                                                                           Tension y) const {
    return overloads(x) || overloads(y) ? kWholeLife.pack() : packed(x, y);
  }

  [[nodiscard]] LIFEMODEL_ONE_COPY constexpr std::uint64_t packed(Tension x, Tension y) const {
    return packed_damage(log2_effective(x, y));
  }
};

}  // namespace lifemodel
