#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "lifemodel/support/bytes.hpp"

namespace storage {

/// What was done under authority, or refused.
enum class Event : std::uint8_t {
  epoch_opened = 1,
  parameters_loaded,
  wrong_mac,
  nonce_reused,
  nonce_expired,
  counter_rolled_back,
  locked_out,
  rejected,  ///< wrong length, unknown routine or tendon, content that does not hold, a transfer
             ///< too long
  disabled,  ///< the node has no key
  not_done,  ///< what the line before announces could not be done
  parameters_refused,  ///< what was stored or configured, at a start, or a block that was proven
                       ///< and that this board cannot count with
  tendon_broken,       ///< a wire was found broken; detail: its cycles, stops
  tendon_slack,        ///< a wire was found loose for the first time; detail: its cycles, stops
};

/// One line of the append-only log.
struct LogEntry {
  std::uint32_t number = 0;    ///< counts the entries from 0, set by the store
  std::uint32_t sequence = 0;  ///< storage sequence at that moment
  Event event = Event::epoch_opened;
  std::uint8_t tendon = 0;
  std::uint16_t epoch = 0;
  std::uint32_t detail = 0;  ///< CRC of the parameter block, or the routine that was refused

  friend constexpr bool operator==(const LogEntry&, const LogEntry&) = default;
};

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
