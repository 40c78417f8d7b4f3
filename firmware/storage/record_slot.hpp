#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "firmware/storage/record_codec.hpp"
#include "firmware/storage/slot_name.hpp"

namespace storage {

/// A life record as it is kept in flash.
struct RecordSlot {
  static constexpr std::size_t kBytes = kRecordBytes;

  static constexpr std::optional<SlotName> name(std::span<const std::byte, kBytes> bytes) {
    const auto record = decode(bytes);
    if (!record) {
      return {};
    }
    return SlotName{record->tendon, record->sequence};
  }
};

}  // namespace storage
