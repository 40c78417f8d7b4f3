#pragma once

#include <cstdint>

#include "lifemodel/extension/fixed.hpp"
#include "lifemodel/extension/sample.hpp"

namespace lifemodel::extension {

/// Temperature-dependent friction: mu (1 + k (T_sheath - T_ref)).
struct FrictionTemperature {
  std::int32_t coefficient = 0;  ///< k in 1/K, Q30
  std::int32_t reference = 0;    ///< T_ref in degrees Celsius, Q16

  static constexpr std::int32_t kMost = 1 << 27;
  [[nodiscard]] constexpr bool plausible() const {
    return coefficient >= -kMost && coefficient <= kMost;
  }
  template <class Word>
  constexpr void words(Word&& word) {
    word(coefficient);
    word(reference);
  }

  /// The factor of mu, Q28.
  [[nodiscard]] constexpr std::int32_t factor(Temperature sheath) const {
    const std::int64_t warmer = std::int64_t{sheath.raw()} - reference;
    return factor_of(rounded(warmer * coefficient, 30 + Temperature::kFractionBits - kFactorBits));
  }
};

}  // namespace lifemodel::extension
