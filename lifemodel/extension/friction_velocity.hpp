#pragma once

#include <cstdint>

#include "lifemodel/extension/fixed.hpp"
#include "lifemodel/extension/sample.hpp"

namespace lifemodel::extension {

/// Stribeck and viscous friction: mu + (mu_s - mu) exp(-|v|/v_s) + kappa |v|.
struct FrictionVelocity {
  std::int32_t stribeck = 0;      ///< (mu_s - mu) log2(e), Q28
  std::int32_t viscous = 0;       ///< kappa log2(e) in s/m, Q24
  std::int32_t log2_a_speed = 0;  ///< log2(e)/v_s in s/m, Q16

  [[nodiscard]] constexpr bool plausible() const {
    return stribeck >= -kOne && stribeck <= kOne && viscous >= -kMostViscous &&
           viscous <= kMostViscous && log2_a_speed > 0;
  }
  template <class Word>
  constexpr void words(Word&& word) {
    word(stribeck);
    word(viscous);
    word(log2_a_speed);
  }

  /// What it adds to mu log2(e), Q28.
  [[nodiscard]] constexpr std::int64_t added(Velocity velocity) const {
    const std::int64_t speed = velocity.raw() < 0 ? -velocity.raw() : velocity.raw();
    constexpr int kDrop = Velocity::kFractionBits + 16 - kExponentBits;
    const std::int64_t slow = exp2_factor(-rounded(speed * log2_a_speed, kDrop));
    return rounded(stribeck * slow, kFactorBits) +
           rounded(viscous * speed, 24 + Velocity::kFractionBits - kFactorBits);
  }

 private:
  static constexpr std::int32_t kMostViscous = 16 << 24;
};

}  // namespace lifemodel::extension
