#pragma once

#include <cstdint>

#include "lifemodel/extension/fixed.hpp"
#include "lifemodel/extension/sample.hpp"
#include "lifemodel/numeric/sine.hpp"

namespace lifemodel::extension {

/// Cogging and torque ripple: I + a sin(k theta) + b cos(k theta).
struct TorqueRipple {
  std::int32_t sine = 0;      ///< a in A, Q24
  std::int32_t cosine = 0;    ///< b in A, Q24
  std::int32_t harmonic = 0;  ///< k, Q16

  static constexpr std::int32_t kMost = 1 << 24;
  [[nodiscard]] constexpr bool plausible() const {
    return sine >= -kMost && sine <= kMost && cosine >= -kMost && cosine <= kMost && harmonic > 0;
  }
  template <class Word>
  constexpr void words(Word&& word) {
    word(sine);
    word(cosine);
    word(harmonic);
  }

  /// What it adds to the current, Q24.
  [[nodiscard]] constexpr std::int64_t added(RotorAngle rotor) const {
    // Whole turns drop out of the product.
    const std::uint64_t turns =
        static_cast<std::uint64_t>(rotor.raw) * static_cast<std::uint32_t>(harmonic);
    const auto phase = static_cast<numeric::Phase>(turns >> 16);
    return rounded(
        std::int64_t{sine} * numeric::sine(phase) + std::int64_t{cosine} * numeric::cosine(phase),
        30);
  }
};

}  // namespace lifemodel::extension
