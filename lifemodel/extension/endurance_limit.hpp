#pragma once

#include <cstdint>

#include "lifemodel/extension/fixed.hpp"

namespace lifemodel::extension {

/// Fatigue limit S_e: T_eff (1 - S_e/T_eff)^share, with share 1 the excess over the limit. The
/// scatter of the limit from wire to wire is no part of it.
struct EnduranceLimit {
  std::int32_t share = 0;       ///< Q28, 0 .. 1
  std::int32_t log2_limit = 0;  ///< of S_e relative to the ultimate tension, Q26

  [[nodiscard]] constexpr bool plausible() const {
    return share >= 0 && share <= kOne && log2_limit >= kNoDamage && log2_limit <= 0;
  }
  template <class Word>
  constexpr void words(Word&& word) {
    word(share);
    word(log2_limit);
  }

  /// log2 T_eff over the limit, Q26; never falls as the one without limit grows. Below the limit a
  /// cycle does the smallest damage there is, in the share of 1.
  [[nodiscard]] constexpr std::int32_t log2_effective(std::int32_t nominal) const {
    constexpr int kDrop = numeric::kLogBits - kExponentBits;
    const std::int32_t part = exp2_factor((std::int64_t{log2_limit} - nominal) >> kDrop);
    const std::int32_t left = part < kOne ? kOne - part : 0;
    const std::int32_t log2_left =
        left > 0 ? log2_of(static_cast<std::uint32_t>(left)) - (kFactorBits << numeric::kLogBits)
                 : kNoDamage;
    const std::int64_t sum = nominal + ((std::int64_t{log2_left} * share) >> kFactorBits);
    return held(sum, kNoDamage, 1 << 30);
  }
};

}  // namespace lifemodel::extension
