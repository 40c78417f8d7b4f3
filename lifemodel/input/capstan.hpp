#pragma once

#include <cstdint>

#include "lifemodel/numeric/logarithm.hpp"
#include "lifemodel/quantity/units.hpp"

namespace lifemodel {

/// tension * 2^exponent, the exponent in Q21. Relative error at most 4e-7. Saturates outside the
/// range of Tension and then raises Flag::saturated in `flags`.
/// @pre the exponent is below 46, where every tension but 0 has saturated
constexpr Tension times_exp2(Tension tension, std::int32_t exponent, Flags& flags) {
  const std::uint32_t factor = numeric::exp2_fraction(static_cast<std::uint32_t>(exponent) &
                                                      ((1u << numeric::kExpBits) - 1));
  // factor * 2^(whole - 31), halved so that 63 bits hold the product.
  const std::int32_t whole = exponent >> numeric::kExpBits;
  const std::int64_t scaled = std::int64_t{tension.raw()} * (factor >> 1);
  const std::int32_t shift = 30 - whole;
  if (shift < 1) {
    // Held where it saturates anyway; the shift is at most 16 here.
    constexpr std::int64_t kHeld = std::int64_t{1} << 40;
    const std::int64_t held = scaled < -kHeld ? -kHeld : scaled > kHeld ? kHeld : scaled;
    return Tension::saturated(held * (std::int64_t{1} << -shift), flags);
  }
  if (shift > 62) {
    return Tension{};
  }
  return Tension::saturated((scaled + (std::int64_t{1} << (shift - 1))) >> shift, flags);
}

/// Direction of the tendon at the output.
enum class Direction : std::uint8_t {
  pulling,    ///< v > 0: friction adds to the input tension
  releasing,  ///< v < 0: friction takes from it
};

/// Output tension to input tension: T_in = T_out exp(+mu phi) while pulling, T_out exp(-mu phi)
/// while releasing; eqs (4), (14). Over a cycle it gives the mean (12) and the amplitude (13).
struct Capstan {
  FrictionExponent friction;  ///< mu log2(e)

  /// Relative error at most 4e-7. Saturates outside the range of Tension and then raises
  /// Flag::saturated in `flags`.
  [[nodiscard]] constexpr Tension input_tension(Tension output, Angle bend, Direction direction,
                                                Flags& flags) const {
    const std::uint64_t product =
        std::uint64_t{friction.raw()} * static_cast<std::uint32_t>(bend.raw());
    constexpr int kDrop =
        FrictionExponent::kFractionBits + Angle::kFractionBits - numeric::kExpBits;
    const auto magnitude =
        static_cast<std::int32_t>((product + (std::uint64_t{1} << (kDrop - 1))) >> kDrop);
    const std::int32_t exponent = direction == Direction::pulling ? magnitude : -magnitude;
    return times_exp2(output, exponent, flags);
  }
};

}  // namespace lifemodel
