#pragma once

#include <cstdint>

#include "lifemodel/input/capstan.hpp"
#include "lifemodel/quantity/units.hpp"

namespace lifemodel::extension {

/// Load-independent friction of seals and sheath preload: T_in + F s.
struct FrictionPreload {
  std::int32_t force = 0;  ///< F relative to the ultimate tension, Q29

  [[nodiscard]] constexpr bool plausible() const { return force >= 0; }
  template <class Word>
  constexpr void words(Word&& word) {
    word(force);
  }

  [[nodiscard]] constexpr Tension added(Tension input, Direction direction, Flags& flags) const {
    const std::int64_t signed_force = direction == Direction::pulling ? force : -force;
    return Tension::saturated(input.raw() + signed_force, flags);
  }
};

}  // namespace lifemodel::extension
