#pragma once

#include "firmware/protocol/messages.hpp"
#include "lifemodel/damage/damage.hpp"
#include "lifemodel/life/weibull.hpp"
#include "lifemodel/tendon.hpp"

namespace app {

/// What the damage of a wire asks for. Never falls as the damage grows.
constexpr protocol::LifeState life_state(const lifemodel::Damage& damage,
                                         const lifemodel::LifeDistribution& life) {
  if (damage >= life.b50.damage()) {
    return protocol::LifeState::worn;
  }
  if (damage >= life.b10.damage()) {
    return protocol::LifeState::replace;
  }
  const lifemodel::LifePoint half_of_b10{life.b10.raw / 2};
  return damage >= half_of_b10.damage() ? protocol::LifeState::inspect
                                        : protocol::LifeState::normal;
}

/// How far a reading with these flags can be trusted.
constexpr protocol::Quality quality(lifemodel::Flags flags, bool trusted) {
  using lifemodel::Flag;
  if (!trusted) {
    return protocol::Quality::untrusted;
  }
  if (flags.has(Flag::saturated)) {
    return protocol::Quality::saturated;
  }
  if (flags.has(Flag::overrun) || flags.has(Flag::residue_overflow) || flags.has(Flag::overload)) {
    return protocol::Quality::bounded;
  }
  return flags.has(Flag::gap) ? protocol::Quality::gaps : protocol::Quality::measured;
}

}  // namespace app
