#pragma once

#include <cstdint>

#include "lifemodel/extension/fixed.hpp"
#include "lifemodel/input/capstan.hpp"

namespace lifemodel::extension {

/// Direction-dependent efficiency of the gear: eta_g (1 + c s).
struct GearAsymmetry {
  std::int32_t asymmetry = 0;  ///< c, Q28

  static constexpr std::int32_t kMost = kOne / 2;
  [[nodiscard]] constexpr bool plausible() const {
    return asymmetry >= -kMost && asymmetry <= kMost;
  }
  template <class Word>
  constexpr void words(Word&& word) {
    word(asymmetry);
  }

  /// The factor of eta_g, Q28.
  [[nodiscard]] constexpr std::int32_t factor(Direction direction) const {
    return direction == Direction::pulling ? kOne + asymmetry : kOne - asymmetry;
  }
};

}  // namespace lifemodel::extension
