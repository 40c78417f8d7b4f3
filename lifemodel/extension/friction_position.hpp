#pragma once

#include <array>
#include <cstdint>

#include "lifemodel/extension/fixed.hpp"
#include "lifemodel/extension/sample.hpp"
#include "lifemodel/numeric/sine.hpp"

namespace lifemodel::extension {

/// Position-dependent friction: mu (1 + g(x)), g a Fourier sum of six harmonics of 2 pi x/L. The
/// position is that of the rotor.
struct FrictionPosition {
  struct Harmonic {
    std::int32_t sine = 0;  ///< Q28
    std::int32_t cosine = 0;
  };
  std::array<Harmonic, 6> harmonics{};
  std::int32_t waves_a_turn = 0;  ///< wavelengths that a turn of the rotor goes, Q28

  static constexpr std::int32_t kMost = kOne;
  [[nodiscard]] constexpr bool plausible() const {
    for (const Harmonic& each : harmonics) {
      if (each.sine < -kMost || each.sine > kMost || each.cosine < -kMost || each.cosine > kMost) {
        return false;
      }
    }
    return waves_a_turn > 0;
  }
  template <class Word>
  constexpr void words(Word&& word) {
    for (Harmonic& each : harmonics) {
      word(each.sine);
      word(each.cosine);
    }
    word(waves_a_turn);
  }

  /// The factor of mu, Q28.
  [[nodiscard]] constexpr std::int32_t factor(RotorAngle rotor) const {
    // Whole waves drop out of the product, however far the rotor has turned.
    const std::uint64_t waves =
        static_cast<std::uint64_t>(rotor.raw) * static_cast<std::uint32_t>(waves_a_turn);
    const auto phase = static_cast<numeric::Phase>(waves >> kFactorBits);
    numeric::Phase multiple = 0;
    std::int64_t sum = 0;
    for (const Harmonic& each : harmonics) {
      multiple += phase;
      sum += std::int64_t{each.sine} * numeric::sine(multiple) +
             std::int64_t{each.cosine} * numeric::cosine(multiple);
    }
    return factor_of(rounded(sum, 30));
  }
};

}  // namespace lifemodel::extension
