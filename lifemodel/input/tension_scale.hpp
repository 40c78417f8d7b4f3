#pragma once

#include <cstdint>

#include "lifemodel/input/factor.hpp"
#include "lifemodel/quantity/units.hpp"

namespace lifemodel {

/// Tension in mN to tension relative to the ultimate tension.
struct TensionScale {
  Factor steps_per_mN;

  /// Saturates outside the range of Tension and then raises Flag::saturated in `flags`.
  [[nodiscard]] constexpr Tension tension(std::int32_t tension_mN, Flags& flags) const {
    return Tension::saturated(steps_per_mN.times(tension_mN), flags);
  }
};

}  // namespace lifemodel
