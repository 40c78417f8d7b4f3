#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "firmware/storage/log_entry.hpp"
#include "firmware/storage/slot.hpp"
#include "firmware/storage/store.hpp"
#include "hal/non_volatile.hpp"

namespace storage {

/// Entries one after another on pages that are never erased.
///
/// A slot whose program was cut or failed is spent. The start reads every slot once; an append
/// spends at most kAttempts slots.
template <hal::NonVolatile Memory, PageRange kPages>
class EntryLog {
  static constexpr std::uint32_t kStride = slot_stride<Memory>(kEntryBytes);
  static constexpr std::uint32_t kSlotsPerPage =
      static_cast<std::uint32_t>(Memory::kPageBytes / kStride);

 public:
  static constexpr std::uint32_t kSlots = kPages.count * kSlotsPerPage;
  static constexpr std::uint32_t kAttempts = 4;

  explicit EntryLog(Memory& memory) : memory_(&memory) {
    for (std::uint32_t slot = 0; slot < kSlots; ++slot) {
      if (is_blank(*memory_, address(slot), kStride)) {
        continue;
      }
      next_ = slot + 1;
      if (const auto entry = read(slot)) {
        number_ = entry->number + 1;
      }
    }
  }

  /// full: nothing was written, and what was stays. failed: the memory refuses.
  hal::Error append(LogEntry entry) {
    entry.number = number_;
    const EntryBytes bytes = encode(entry);
    for (std::uint32_t attempt = 0; attempt < kAttempts; ++attempt) {
      if (next_ == kSlots) {
        return attempt == 0 ? hal::Error::full : hal::Error::failed;
      }
      if (write_slot(*memory_, address(next_++), std::span<const std::byte, kEntryBytes>(bytes)) ==
          hal::Error::none) {
        ++number_;
        return hal::Error::none;
      }
    }
    return hal::Error::failed;
  }

  /// The i-th entry that can be read, from the oldest. Reads at most every slot. An entry that was
  /// written again because its first slot looked bad counts once.
  [[nodiscard]] std::optional<LogEntry> entry(std::uint32_t i) {
    std::optional<LogEntry> last;
    for (std::uint32_t slot = 0; slot < next_; ++slot) {
      const auto found = read(slot);
      if (!found || (last && last->number == found->number)) {
        continue;
      }
      if (i-- == 0) {
        return found;
      }
      last = found;
    }
    return {};
  }

 private:
  static constexpr std::uint32_t address(std::uint32_t slot) {
    constexpr auto kPageBytes = static_cast<std::uint32_t>(Memory::kPageBytes);
    return (kPages.first + slot / kSlotsPerPage) * kPageBytes + slot % kSlotsPerPage * kStride;
  }

  [[nodiscard]] std::optional<LogEntry> read(std::uint32_t slot) {
    EntryBytes bytes;
    if (memory_->read(address(slot), bytes) != hal::Error::none) {
      return {};
    }
    return decode_entry(bytes);
  }

  Memory* memory_;
  std::uint32_t next_ = 0;    ///< slot; all from it on are blank
  std::uint32_t number_ = 0;  ///< of the next entry
};

}  // namespace storage
