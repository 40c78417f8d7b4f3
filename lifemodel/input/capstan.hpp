#pragma once

#include <cstdint>

#include "lifemodel/input/exponential.hpp"
#include "lifemodel/numeric/exp2.hpp"
#include "lifemodel/quantity/units.hpp"

namespace lifemodel {

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
