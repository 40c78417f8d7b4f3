#pragma once

#include <algorithm>
#include <cstdint>

#include "lifemodel/extension/fixed.hpp"
#include "lifemodel/numeric/quotient.hpp"
#include "lifemodel/quantity/units.hpp"

namespace lifemodel::extension {

/// Another mean-stress law in place of Gerber's, by a share:
/// T_eff = T_Gerber^(1 - share) T_law^share with Walker's (T_m + T_a)^(1-w) T_a^w, or where w is 0
/// Goodman's T_a/(1 - T_m/T_u).
struct MeanStress {
  std::int32_t share = 0;   ///< Q28, 0 .. 1
  std::int32_t walker = 0;  ///< w, Q28, 0 .. 1

  [[nodiscard]] constexpr bool plausible() const {
    return share >= 0 && share <= kOne && walker >= 0 && walker <= kOne;
  }
  template <class Word>
  constexpr void words(Word&& word) {
    word(share);
    word(walker);
  }

  /// log2 T_eff from that of Gerber, Q26. Never falls as the cycle widens. Precondition: x != y,
  /// neither reaches the ultimate tension.
  [[nodiscard]] constexpr std::int32_t log2_effective(std::int32_t gerber, Tension x,
                                                      Tension y) const {
    return weighted(share, walker != 0 ? log2_walker(x, y) : log2_goodman(x, y), gerber);
  }

 private:
  /// share * of + (1 - share) * other; each part is rounded down, which keeps order.
  static constexpr std::int32_t weighted(std::int32_t share, std::int32_t of, std::int32_t other) {
    return static_cast<std::int32_t>((std::int64_t{of} * share) >> kFactorBits) +
           static_cast<std::int32_t>((std::int64_t{other} * (kOne - share)) >> kFactorBits);
  }

  [[nodiscard]] constexpr std::int32_t log2_walker(Tension x, Tension y) const {
    const Tension highest = std::max(x, y);
    if (highest.raw() <= 0) {
      return kNoDamage;
    }
    constexpr std::int32_t kScale = Tension::kFractionBits << numeric::kLogBits;
    constexpr std::int32_t kHalf = 1 << numeric::kLogBits;
    const std::int32_t amplitude = log2_of(distance(x, y).raw()) - kScale - kHalf;
    return weighted(walker, amplitude, log2_of(static_cast<std::uint32_t>(highest.raw())) - kScale);
  }

  static constexpr std::int32_t log2_goodman(Tension x, Tension y) {
    constexpr std::uint32_t kTwo = 2u << Tension::kFractionBits;
    const auto sum = static_cast<std::uint32_t>(x.raw() + y.raw());
    return numeric::log2(numeric::quotient(distance(x, y).raw(), kTwo - sum));
  }
};

}  // namespace lifemodel::extension
