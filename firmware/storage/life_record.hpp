#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "firmware/storage/wire_history.hpp"
#include "lifemodel/damage/damage.hpp"
#include "lifemodel/quantity/flags.hpp"
#include "lifemodel/support/bytes.hpp"
#include "lifemodel/support/result.hpp"

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
  WireHistory history{};  ///< of this wire

  friend constexpr bool operator==(const LifeRecord&, const LifeRecord&) = default;
};

inline constexpr std::uint32_t kRecordMagic = 0x524c4c54;  ///< "TLLR"
inline constexpr std::uint8_t kRecordSchema = 2;
inline constexpr std::size_t kRecordBytes = 88;
/// That of records without a history of the wire, which are still read.
inline constexpr std::uint8_t kFormerRecordSchema = 1;
inline constexpr std::size_t kFormerRecordBytes = 64;

/// A record as it is stored, in little-endian words: magic; schema, tendon, flags and notes in a
/// byte each; sequence; epoch and slack events (up to 65,535) in half a word each; epoch damage
/// (4); lifetime damage (4); cycles (2); configuration; of the history of the wire peak, excursions
/// above 50, 70 and 90 %, seconds below the minimum and seconds of operation; CRC-32 of all before
/// it. Notes have bit 0 for past_lost and bit 1 for a wire that broke, the rest is zero. Schema 1
/// has no history.
using RecordBytes = std::array<std::byte, kRecordBytes>;

/// Why a record is refused.
enum class RecordError : std::uint8_t {
  none,
  wrong_size,      ///< as long as a record of no schema
  not_a_record,    ///< other magic
  unknown_schema,  ///< made by another version of this firmware, or of another size
  damaged,         ///< the CRC does not fit
  implausible,     ///< unknown flags or notes, or more damage of the wire than of all wires
};

/// The reason in words.
constexpr const char* to_string(RecordError error) {
  switch (error) {
    case RecordError::none:
      return "accepted";
    case RecordError::wrong_size:
      return "wrong size: a life record has 88 bytes, of schema 1 64";
    case RecordError::not_a_record:
      return "not a life record";
    case RecordError::unknown_schema:
      return "unknown schema: this firmware reads schemas 1 and 2";
    case RecordError::damaged:
      return "damaged: the CRC-32 does not fit";
    case RecordError::implausible:
      return "implausible: unknown flags, or more damage of the wire than of all wires";
  }
  return "unknown";
}

namespace detail {

constexpr void put(lifemodel::ByteWriter& out, const lifemodel::Damage& damage) {
  for (const std::uint32_t word : damage.words()) {
    out.u32(word);
  }
}

constexpr lifemodel::Damage get_damage(lifemodel::ByteReader& in) {
  lifemodel::Damage::Words words{};
  for (std::uint32_t& word : words) {
    word = in.u32();
  }
  return lifemodel::Damage::from_words(words);
}

inline constexpr std::uint32_t kPastLost = 1;
inline constexpr std::uint32_t kBroken = 2;
inline constexpr std::uint32_t kMostSlackEvents = 0xffff;

constexpr void put(lifemodel::ByteWriter& out, const WireHistory& history) {
  out.u32(history.peak);
  out.u32(history.above_50);
  out.u32(history.above_70);
  out.u32(history.above_90);
  out.u32(history.below_minimum_s);
  out.u32(history.operated_s);
}

constexpr void get_history(lifemodel::ByteReader& in, WireHistory& history) {
  history.peak = in.u32();
  history.above_50 = in.u32();
  history.above_70 = in.u32();
  history.above_90 = in.u32();
  history.below_minimum_s = in.u32();
  history.operated_s = in.u32();
}

}  // namespace detail

constexpr RecordBytes encode(const LifeRecord& record) {
  RecordBytes bytes{};
  lifemodel::ByteWriter out(bytes);
  out.u32(kRecordMagic);
  out.u32(std::uint32_t{kRecordSchema} | (std::uint32_t{record.tendon} << 8) |
          (std::uint32_t{record.flags} << 16) | (record.past_lost ? detail::kPastLost << 24 : 0u) |
          (record.history.broken ? detail::kBroken << 24 : 0u));
  out.u32(record.sequence);
  out.u32(record.epoch | (std::min(record.history.slack_events, detail::kMostSlackEvents) << 16));
  detail::put(out, record.epoch_damage);
  detail::put(out, record.lifetime_damage);
  out.u64(record.epoch_cycles);
  out.u32(record.configuration);
  detail::put(out, record.history);
  out.u32(lifemodel::crc32(std::span(bytes).first(out.size())));
  return bytes;
}

/// Whether the values of a record can be of one wire.
constexpr bool plausible(const LifeRecord& record) {
  return (record.flags & ~lifemodel::kAllFlags) == 0 &&
         record.epoch_damage <= record.lifetime_damage;
}

/// Checks the bytes of a record and reads it, or says why it cannot be trusted.
constexpr lifemodel::Result<LifeRecord, RecordError> decode(std::span<const std::byte> bytes) {
  const bool former = bytes.size() == kFormerRecordBytes;
  if (!former && bytes.size() != kRecordBytes) {
    return RecordError::wrong_size;
  }
  lifemodel::ByteReader in(bytes);
  if (in.u32() != kRecordMagic) {
    return RecordError::not_a_record;
  }
  const std::uint32_t what = in.u32();
  if ((what & 0xff) != (former ? kFormerRecordSchema : kRecordSchema)) {
    return RecordError::unknown_schema;
  }
  if (lifemodel::crc32(bytes.first(bytes.size() - 4)) !=
      lifemodel::ByteReader(bytes.last(4)).u32()) {
    return RecordError::damaged;
  }
  LifeRecord record;
  record.tendon = static_cast<std::uint8_t>(what >> 8);
  record.flags = static_cast<std::uint8_t>(what >> 16);
  const std::uint32_t notes = what >> 24;
  record.past_lost = (notes & detail::kPastLost) != 0;
  record.history.broken = (notes & detail::kBroken) != 0;
  record.sequence = in.u32();
  const std::uint32_t epoch = in.u32();
  record.epoch = static_cast<std::uint16_t>(epoch);
  record.history.slack_events = epoch >> 16;
  record.epoch_damage = detail::get_damage(in);
  record.lifetime_damage = detail::get_damage(in);
  record.epoch_cycles = in.u64();
  record.configuration = in.u32();
  if (!former) {
    detail::get_history(in, record.history);
  }
  const std::uint32_t known = former ? detail::kPastLost : detail::kPastLost | detail::kBroken;
  if ((notes & ~known) != 0 || (former && record.history.slack_events != 0) || !plausible(record)) {
    return RecordError::implausible;
  }
  return record;
}

/// Whether `next` may be stored after `last`: wires are counted up, the damage of all wires never
/// falls, and neither do damage, cycles and history of the same wire.
constexpr bool may_follow(const LifeRecord& next, const LifeRecord& last) {
  if (!plausible(next) || next.epoch < last.epoch || next.lifetime_damage < last.lifetime_damage) {
    return false;
  }
  return next.epoch > last.epoch ||
         (next.epoch_damage >= last.epoch_damage && next.epoch_cycles >= last.epoch_cycles &&
          may_follow(next.history, last.history));
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
