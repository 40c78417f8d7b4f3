#pragma once

#include <cstdint>

#include "lifemodel/extension/fixed.hpp"
#include "lifemodel/quantity/units.hpp"

namespace lifemodel::extension {

/// Bending stress of the wire over a small radius: T_eff (1 + c (d_w/D)/T_a)^share.
struct BendingFatigue {
  std::int32_t share = 0;       ///< Q28, 0 .. 1
  std::int32_t twice_bend = 0;  ///< 2 c d_w/D relative to the ultimate tension, Q29

  static constexpr std::int32_t kMost = 3 << Tension::kFractionBits;
  [[nodiscard]] constexpr bool plausible() const {
    return share >= 0 && share <= kOne && twice_bend >= 0 && twice_bend <= kMost;
  }
  template <class Word>
  constexpr void words(Word&& word) {
    word(share);
    word(twice_bend);
  }

  /// log2 T_eff with the bend, Q26. Precondition: x != y, neither reaches the ultimate tension.
  [[nodiscard]] constexpr std::int32_t log2_effective(std::int32_t nominal, Tension x,
                                                      Tension y) const {
    const std::uint32_t range = distance(x, y).raw();
    const std::int32_t grown = log2_of(range + static_cast<std::uint32_t>(twice_bend));
    return nominal +
           static_cast<std::int32_t>((std::int64_t{grown - log2_of(range)} * share) >> kFactorBits);
  }
};

}  // namespace lifemodel::extension
