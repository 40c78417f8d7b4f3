#pragma once

#include <cstdint>

#include "lifemodel/damage/damage.hpp"

namespace storage {

/// What outlives a power cut of one tendon.
struct LifeRecord {
  std::uint32_t sequence = 0;  ///< counts the saves of this node; never falls, never wraps
  std::uint8_t tendon = 0;
  std::uint8_t flags = 0;             ///< lifemodel::Flags, sticky over restarts
  std::uint16_t epoch = 0;            ///< counts the wires that have been put in
  lifemodel::Damage epoch_damage;     ///< of this wire
  lifemodel::Damage lifetime_damage;  ///< of all wires so far, this one included; never cleared
  std::uint64_t epoch_cycles = 0;     ///< closed, of this wire
  std::uint32_t configuration = 0;    ///< CRC-32 of the parameter block it was counted under
  /// An earlier record of this wire was lost, so the damage is a lower bound. Set by the store,
  /// until the next wire is put in.
  bool past_lost = false;

  friend constexpr bool operator==(const LifeRecord&, const LifeRecord&) = default;
};

}  // namespace storage
