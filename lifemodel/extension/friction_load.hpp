#pragma once

#include <algorithm>
#include <cstdint>

#include "lifemodel/extension/fixed.hpp"
#include "lifemodel/input/factor.hpp"
#include "lifemodel/quantity/units.hpp"

namespace lifemodel::extension {

/// Load-dependent friction, mu (T/50 N)^-k at each place of the sheath. Along it
/// ln(T_in/T_out) = ln(1 + z)/k with z = k mu phi s (T_out/50 N)^-k.
struct FrictionLoad {
  std::int32_t exponent = 0;        ///< k, Q28, -1 .. 1
  std::int32_t log2_reference = 0;  ///< log2 of 50 N in steps of Tension, Q26
  Factor inverse{1 << 30, 31};      ///< 1/|k|, of Q24 in Q21

  [[nodiscard]] constexpr bool plausible() const {
    return exponent >= -kOne && exponent <= kOne && inverse.plausible();
  }
  template <class Word>
  constexpr void words(Word&& word) {
    word(exponent);
    word(log2_reference);
    word(inverse.mantissa);
    word(inverse.shift);
  }

  /// log2(T_in/T_out), Q21, where it would be `plain` without load dependence. Raises
  /// Flag::saturated where 1 + z is held at 1/1024.
  [[nodiscard]] constexpr std::int64_t log2_ratio(std::int64_t plain, Tension output,
                                                  Flags& flags) const {
    if (output.raw() <= 0) {
      return plain;
    }
    const std::int64_t here = at_load(plain, output);
    // z in Q28: k times the exponent to base e.
    constexpr std::int64_t kLn2 = 186065279;  // Q28
    const std::int64_t log2_z = rounded(here * exponent, kExponentBits);
    std::int64_t z = rounded(std::clamp(log2_z, -kMostZ, kMostZ) * kLn2, kFactorBits);
    constexpr std::int64_t kLeast = kOne / 1024 - kOne;
    if (z < kLeast) {
      flags.raise(Flag::saturated);
      z = kLeast;
    }
    constexpr std::int64_t kSmall = kOne / 8;
    return z > -kSmall && z < kSmall ? rounded(here * series(z), kFactorBits) : quotient(z);
  }

 private:
  static constexpr std::int64_t kMostZ = std::int64_t{1} << 33;

  /// The exponent with mu at the load of the output, Q21.
  [[nodiscard]] constexpr std::int64_t at_load(std::int64_t plain, Tension output) const {
    const std::int64_t log2_load =
        std::int64_t{log2_of(static_cast<std::uint32_t>(output.raw()))} - log2_reference;
    const std::int64_t power =
        -rounded(log2_load * exponent, numeric::kLogBits + kFactorBits - kExponentBits);
    const auto whole = static_cast<int>(power >> kExponentBits);
    const std::int64_t fraction =
        numeric::exp2_fraction(static_cast<std::uint32_t>(power) & ((1u << kExponentBits) - 1));
    constexpr std::int64_t kMost = std::int64_t{1} << 33;
    return std::clamp(rounded(plain * fraction, std::clamp(31 - whole, 1, 62)), -kMost, kMost);
  }

  /// ln(1 + z)/z in Q28 for |z| <= 1/8, by its power series.
  static constexpr std::int64_t series(std::int64_t z) {
    std::int64_t sum = 0;
    for (int term = 9; term >= 1; --term) {
      const std::int64_t one_over = kOne / term;
      sum = one_over - rounded(sum * z, kFactorBits);
    }
    return sum;
  }

  /// log2(1 + z)/k in Q21.
  [[nodiscard]] constexpr std::int64_t quotient(std::int64_t z) const {
    const std::int64_t term = std::min(kOne + z, (std::int64_t{1} << 32) - 1);
    const std::int32_t log2_term =
        log2_of(static_cast<std::uint32_t>(term)) - (kFactorBits << numeric::kLogBits);
    const std::int64_t result = inverse.times(log2_term >> 2);
    return exponent < 0 ? -result : result;
  }
};

}  // namespace lifemodel::extension
