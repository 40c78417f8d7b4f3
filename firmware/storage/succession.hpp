#pragma once

#include "firmware/storage/life_record.hpp"
#include "firmware/storage/record_codec.hpp"

namespace storage {

/// Whether `next` may be stored after `last`: wires are counted up, the damage of all wires never
/// falls, and neither do damage and cycles of the same wire.
constexpr bool may_follow(const LifeRecord& next, const LifeRecord& last) {
  if (!plausible(next) || next.epoch < last.epoch || next.lifetime_damage < last.lifetime_damage) {
    return false;
  }
  return next.epoch > last.epoch ||
         (next.epoch_damage >= last.epoch_damage && next.epoch_cycles >= last.epoch_cycles);
}

}  // namespace storage
