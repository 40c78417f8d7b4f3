#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "firmware/storage/life_record.hpp"
#include "firmware/storage/store.hpp"
#include "lifemodel/extension/extended_block.hpp"

namespace storage_test {

/// Records of a life that continues: a step later means more damage of every tendon, each with its
/// own. No two steps and no two tendons have the same.
inline storage::LifeRecord record_of(std::size_t tendon, std::uint32_t step,
                                     std::uint16_t epoch = 0, std::uint32_t opened = 0) {
  const auto key = static_cast<std::uint32_t>(tendon);
  storage::LifeRecord record;
  record.tendon = static_cast<std::uint8_t>(tendon);
  record.flags = step > 100 ? 8 : 0;
  record.epoch = epoch;
  record.epoch_damage =
      lifemodel::Damage::from_words({step * 7 + 1, 0x1000 * key + 5, step - opened, 0});
  record.lifetime_damage =
      lifemodel::Damage::from_words({step * 7 + 1, 0x1000 * key + 5, step + 1, key});
  record.epoch_cycles = (std::uint64_t{step - opened} << 30) + key;
  record.configuration = 0xc0ffee00u + key;
  record.history = {.peak = step << 12,
                    .above_50 = 3 * (step - opened),
                    .above_70 = 2 * (step - opened) + key,
                    .above_90 = step - opened,
                    .below_minimum_s = 5 * (step - opened),
                    .operated_s = 60 * (step - opened),
                    .slack_events = (step - opened) / 4,
                    .broken = step - opened > 50};
  return record;
}

/// A record as firmware stored it before there were histories of wires, without that of this one.
inline std::array<std::byte, storage::kFormerRecordBytes> former_bytes(
    const storage::LifeRecord& record) {
  std::array<std::byte, storage::kFormerRecordBytes> bytes{};
  lifemodel::ByteWriter out(bytes);
  out.u32(storage::kRecordMagic);
  out.u32(1u | (std::uint32_t{record.tendon} << 8) | (std::uint32_t{record.flags} << 16) |
          (record.past_lost ? 1u << 24 : 0u));
  out.u32(record.sequence);
  out.u32(record.epoch);
  for (const lifemodel::Damage& damage : {record.epoch_damage, record.lifetime_damage}) {
    for (const std::uint32_t word : damage.words()) {
      out.u32(word);
    }
  }
  out.u64(record.epoch_cycles);
  out.u32(record.configuration);
  out.u32(lifemodel::crc32(std::span(bytes).first(60)));
  return bytes;
}

template <std::size_t kTendons>
std::array<storage::LifeRecord, kTendons> records_of(std::uint32_t step) {
  std::array<storage::LifeRecord, kTendons> records;
  for (std::size_t tendon = 0; tendon < kTendons; ++tendon) {
    records[tendon] = record_of(tendon, step);
  }
  return records;
}

/// The same record but for what the store sets.
inline bool same_life(storage::LifeRecord a, const storage::LifeRecord& b) {
  a.sequence = b.sequence;
  a.past_lost = b.past_lost;
  return a == b;
}

/// A block that differs from others by `number`; the store does not look into it.
inline lifemodel::ExtendedBlock block_of(std::uint32_t number,
                                         std::size_t size = lifemodel::kBlockBytes) {
  std::array<std::byte, lifemodel::kMostExtendedBytes> bytes{};
  for (std::size_t i = 0; i < size; ++i) {
    bytes[i] = static_cast<std::byte>(number * 31 + i);
  }
  return lifemodel::ExtendedBlock(std::span(bytes).first(size));
}

inline storage::LogEntry entry_of(std::uint32_t number) {
  storage::LogEntry entry;
  entry.sequence = number * 3;
  entry.event = storage::Event::parameters_loaded;
  entry.tendon = static_cast<std::uint8_t>(number % 4);
  entry.epoch = static_cast<std::uint16_t>(number);
  entry.detail = ~number;
  return entry;
}

}  // namespace storage_test
