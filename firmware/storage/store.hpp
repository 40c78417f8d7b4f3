#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "firmware/storage/life_record.hpp"
#include "hal/error.hpp"
#include "lifemodel/block/parameter_block.hpp"

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
  not_done,  ///< what the line before tells of could not be done
};

/// One line of the append-only log.
struct LogEntry {
  std::uint32_t number = 0;    ///< counts the entries from 0, set by the store
  std::uint32_t sequence = 0;  ///< storage sequence at that moment
  Event event = Event::epoch_opened;
  std::uint8_t tendon = 0;
  std::uint16_t epoch = 0;
  std::uint32_t detail = 0;  ///< configuration CRC, or the routine that was refused

  friend constexpr bool operator==(const LogEntry&, const LogEntry&) = default;
};

/// Keeps the life record through power cuts.
///
/// load(tendon): the committed record with the highest sequence; nothing if there is none.
/// past_lost(): true where an earlier record of a wire that is still in use was lost: the memory is
/// not blank and yet a tendon that once had a record has none, or its record says so. Stays until
/// the next wire is put in.
/// save(records): one record a tendon, in the order of the tendons; `sequence` and `past_lost` are
/// set by the store. All or an Error: out_of_range where one of them may not follow what is stored
/// (see may_follow()), and then nothing is written; after a power cut each tendon has its old or
/// its new record.
/// sequence(): of the last save; 0 if there was none. Never falls, not even over restarts.
/// load_parameters(tendon): the block, unchecked; nothing if none was saved.
/// append(entry): the log grows until it is full; then Error::full, and the first entries stay.
/// log(i): the i-th entry from the oldest; nothing past the end.
template <class T>
concept Store = requires(T& store, std::size_t tendon, std::span<const LifeRecord> records,
                         const lifemodel::ParameterBlock& block, const LogEntry& entry,
                         std::uint32_t i) {
  { store.load(tendon) } -> std::same_as<std::optional<LifeRecord>>;
  { store.past_lost() } -> std::same_as<bool>;
  { store.save(records) } -> std::same_as<hal::Error>;
  { store.sequence() } -> std::same_as<std::uint32_t>;
  { store.load_parameters(tendon) } -> std::same_as<std::optional<lifemodel::ParameterBlock>>;
  { store.save_parameters(tendon, block) } -> std::same_as<hal::Error>;
  { store.append(entry) } -> std::same_as<hal::Error>;
  { store.log(i) } -> std::same_as<std::optional<LogEntry>>;
};

}  // namespace storage
