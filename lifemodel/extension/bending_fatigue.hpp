#pragma once

#include <cstdint>

#include "lifemodel/extension/fixed.hpp"
#include "lifemodel/extension/mean_stress.hpp"
#include "lifemodel/quantity/units.hpp"

namespace lifemodel::extension {

/// Bending stress of the wire over a small radius: T_a + c d_w/D in place of T_a in the law of mean
/// stress, by a share: T_eff(T_a)^(1 - share) T_eff(T_a + c d_w/D)^share.
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

  /// log2 T_eff with the bend, Q26. Each of the two laws that it lies between never falls as the
  /// cycle widens, so it does not either. Precondition: x != y, neither reaches the ultimate
  /// tension.
  [[nodiscard]] constexpr std::int32_t log2_effective(const MeanStress& mean_stress, Tension x,
                                                      Tension y) const {
    if (share == 0) {
      return mean_stress.log2_effective(x, y, 0);
    }
    const std::int32_t bent =
        mean_stress.log2_effective(x, y, static_cast<std::uint32_t>(twice_bend));
    return share == kOne ? bent : weighted(share, bent, mean_stress.log2_effective(x, y, 0));
  }
};

}  // namespace lifemodel::extension
