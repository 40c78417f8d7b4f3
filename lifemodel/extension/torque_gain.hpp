#pragma once

#include <cstdint>

#include "lifemodel/extension/fixed.hpp"
#include "lifemodel/extension/sample.hpp"

namespace lifemodel::extension {

/// A torque constant that falls as the winding warms: K_t (1 - alpha (T_winding - T_ref)).
struct TorqueGain {
  std::int32_t droop = 0;      ///< alpha in 1/K, Q30
  std::int32_t reference = 0;  ///< T_ref in degrees Celsius, Q16

  static constexpr std::int32_t kMost = 1 << 27;
  /// The factor does not fall below 0.05.
  static constexpr std::int32_t kLeast = 13421773;
  [[nodiscard]] constexpr bool plausible() const { return droop >= 0 && droop <= kMost; }
  template <class Word>
  constexpr void words(Word&& word) {
    word(droop);
    word(reference);
  }

  /// The factor of K_t, Q28.
  [[nodiscard]] constexpr std::int32_t factor(Temperature winding) const {
    const std::int64_t warmer = std::int64_t{winding.raw()} - reference;
    const std::int32_t factor =
        factor_of(-rounded(warmer * droop, 30 + Temperature::kFractionBits - kFactorBits));
    return factor < kLeast ? kLeast : factor;
  }
};

}  // namespace lifemodel::extension
