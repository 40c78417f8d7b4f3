#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "firmware/storage/life_record.hpp"
#include "firmware/storage/log_entry.hpp"
#include "hal/error.hpp"
#include "lifemodel/extension/extended_block.hpp"

namespace storage {

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
/// load_parameters(tendon): the block that was saved last and is whole, its content unchecked;
/// nothing if there is none. parameters_torn(tendon): true where one was written after it, of this
/// tendon or of one that cannot be told, and is not whole. append(entry): the log grows until it is
/// full; then Error::full, and the first entries stay. log(i): the i-th entry from the oldest;
/// nothing past the end.
template <class T>
concept Store = requires(T& store, std::size_t tendon, std::span<const LifeRecord> records,
                         const lifemodel::ExtendedBlock& block, const LogEntry& entry,
                         std::uint32_t i) {
  { store.load(tendon) } -> std::same_as<std::optional<LifeRecord>>;
  { store.past_lost() } -> std::same_as<bool>;
  { store.save(records) } -> std::same_as<hal::Error>;
  { store.sequence() } -> std::same_as<std::uint32_t>;
  { store.load_parameters(tendon) } -> std::same_as<std::optional<lifemodel::ExtendedBlock>>;
  { store.parameters_torn(tendon) } -> std::same_as<bool>;
  { store.save_parameters(tendon, block) } -> std::same_as<hal::Error>;
  { store.append(entry) } -> std::same_as<hal::Error>;
  { store.log(i) } -> std::same_as<std::optional<LogEntry>>;
};

}  // namespace storage
