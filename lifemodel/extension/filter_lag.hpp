#pragma once

#include <algorithm>
#include <cstdint>

#include "lifemodel/extension/fixed.hpp"
#include "lifemodel/quantity/units.hpp"

namespace lifemodel::extension {

/// The inverse of a first-order lag: T + tau dT/dt, with the difference to the sample before.
struct FilterLag {
  std::int32_t periods = 0;  ///< tau in sample periods, Q16

  [[nodiscard]] constexpr bool plausible() const { return periods >= 0; }
  template <class Word>
  constexpr void words(Word&& word) {
    word(periods);
  }

  /// How far it may move a tension: an eighth of the ultimate one.
  static constexpr std::int64_t kMost = kUltimate.raw() / 8;

  [[nodiscard]] constexpr Tension undone(Tension before, Tension now, Flags& flags) const {
    // Beyond 2^31 the bound holds anyway.
    const std::int64_t step = std::clamp(std::int64_t{now.raw()} - before.raw(),
                                         -std::int64_t{kInt32Max}, std::int64_t{kInt32Max});
    const std::int64_t behind = std::clamp(rounded(step * periods, 16), -kMost, kMost);
    return Tension::saturated(now.raw() + behind, flags);
  }
};

}  // namespace lifemodel::extension
