#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "firmware/storage/store.hpp"
#include "lifemodel/support/bytes.hpp"
#include "lifemodel/support/crc32.hpp"

namespace storage {

inline constexpr std::uint32_t kEntryMagic = 0x454c4c54;  ///< "TLLE"
inline constexpr std::size_t kEntryBytes = 24;

/// A line of the log as it is stored, in little-endian words: magic; number; sequence; event,
/// tendon and epoch in 1, 1 and 2 bytes; detail; CRC-32 of all before it.
using EntryBytes = std::array<std::byte, kEntryBytes>;

constexpr EntryBytes encode(const LogEntry& entry) {
  EntryBytes bytes{};
  lifemodel::ByteWriter out(bytes);
  out.u32(kEntryMagic);
  out.u32(entry.number);
  out.u32(entry.sequence);
  out.u32(static_cast<std::uint32_t>(entry.event) | (std::uint32_t{entry.tendon} << 8) |
          (std::uint32_t{entry.epoch} << 16));
  out.u32(entry.detail);
  out.u32(lifemodel::crc32(std::span(bytes).first(out.size())));
  return bytes;
}

/// Nothing where the bytes cannot be trusted. The event may be one that a later firmware knows.
constexpr std::optional<LogEntry> decode_entry(std::span<const std::byte, kEntryBytes> bytes) {
  lifemodel::ByteReader in(bytes);
  if (in.u32() != kEntryMagic || lifemodel::crc32(bytes.first(kEntryBytes - 4)) !=
                                     lifemodel::ByteReader(bytes.last(4)).u32()) {
    return {};
  }
  LogEntry entry;
  entry.number = in.u32();
  entry.sequence = in.u32();
  const std::uint32_t what = in.u32();
  entry.event = static_cast<Event>(what & 0xff);
  entry.tendon = static_cast<std::uint8_t>(what >> 8);
  entry.epoch = static_cast<std::uint16_t>(what >> 16);
  entry.detail = in.u32();
  return entry;
}

}  // namespace storage
