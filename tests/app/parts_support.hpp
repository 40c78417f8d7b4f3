#pragma once

#include "lifemodel/damage/damage.hpp"

namespace app {

/// n * 2^-exponent lives.
inline lifemodel::Damage lives(std::uint32_t n, int exponent) {
  lifemodel::Damage damage;
  lifemodel::Flags flags;
  damage.add({1u << 31, lifemodel::Damage::kFractionBits - 31 - exponent}, n, flags);
  return damage;
}

}  // namespace app
