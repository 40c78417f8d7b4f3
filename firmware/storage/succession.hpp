#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

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

/// What is stored of each tendon.
template <std::size_t kTendons>
using Lives = std::array<std::optional<LifeRecord>, kTendons>;

/// Whether there is one record a tendon, in their order, and each may follow what is stored.
template <std::size_t kTendons>
constexpr bool may_follow(std::span<const LifeRecord> records, const Lives<kTendons>& last) {
  if (records.size() != kTendons) {
    return false;
  }
  for (std::size_t tendon = 0; tendon < kTendons; ++tendon) {
    const LifeRecord& record = records[tendon];
    const bool follows = last[tendon] ? may_follow(record, *last[tendon]) : plausible(record);
    if (record.tendon != tendon || !follows) {
      return false;
    }
  }
  return true;
}

/// `record` with what the store sets. `lost`: the past of the wire before this save was lost.
constexpr LifeRecord successor(LifeRecord record, const std::optional<LifeRecord>& last, bool lost,
                               std::uint32_t sequence) {
  const bool next_wire = last && record.epoch > last->epoch;
  record.sequence = sequence;
  record.past_lost = lost && !next_wire;
  return record;
}

}  // namespace storage
