#pragma once

#include <cstdint>

#include "lifemodel/extension/fixed.hpp"

namespace lifemodel::extension {

/// Wear or run-in of the sheath: mu (1 + a (n/1000)^p), or mu (1 + a exp(-n/n0)) where p is 0.
struct FrictionWear {
  std::int32_t log2_size = 0;  ///< log2 |a|, Q21
  std::int32_t lowers = 0;     ///< 1 where a is negative
  std::int32_t exponent = 0;   ///< p, Q28, 0 .. 2
  std::int32_t fading = 0;     ///< log2(e) / (2 n0) for each half cycle, Q31, where p is 0

  [[nodiscard]] constexpr bool plausible() const {
    return log2_size >= -(64 << kExponentBits) && log2_size <= 0 && (lowers & ~1) == 0 &&
           exponent >= 0 && exponent <= 2 * kOne && fading >= 0 && (exponent == 0) == (fading != 0);
  }
  template <class Word>
  constexpr void words(Word&& word) {
    word(log2_size);
    word(lowers);
    word(exponent);
    word(fading);
  }

  /// The factor of mu after so many half cycles, Q28.
  [[nodiscard]] constexpr std::int32_t factor(std::uint32_t half_cycles) const {
    const std::int64_t size = exp2_factor(log2_size + log2_growth(half_cycles));
    return factor_of(lowers != 0 ? -size : size);
  }

 private:
  /// Q21.
  [[nodiscard]] constexpr std::int64_t log2_growth(std::uint32_t half_cycles) const {
    constexpr std::int64_t kNothing = -(std::int64_t{1} << 40);
    if (exponent == 0) {
      return -static_cast<std::int64_t>(
          (std::uint64_t{half_cycles} * static_cast<std::uint32_t>(fading)) >>
          (31 - kExponentBits));
    }
    if (half_cycles == 0) {
      return kNothing;
    }
    constexpr std::int32_t kLog2HalfCyclesOfReference = 735901326;  // log2 of 2000, Q26
    const std::int64_t log2_ratio = std::int64_t{log2_of(half_cycles)} - kLog2HalfCyclesOfReference;
    return rounded(log2_ratio * exponent, numeric::kLogBits + kFactorBits - kExponentBits);
  }
};

}  // namespace lifemodel::extension
