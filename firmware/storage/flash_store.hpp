#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

#include "firmware/storage/entry_log.hpp"
#include "firmware/storage/life_record.hpp"
#include "firmware/storage/newest_log.hpp"
#include "firmware/storage/slot.hpp"
#include "firmware/storage/store.hpp"
#include "hal/non_volatile.hpp"
#include "lifemodel/extension/extended_block.hpp"
#include "lifemodel/support/bytes.hpp"
#include "lifemodel/support/saturating.hpp"

namespace storage {

/// A life record as it is kept in flash.
struct RecordSlot {
  static constexpr std::size_t kBytes = kRecordBytes;

  /// A record of schema 1.
  struct Former {
    static constexpr std::size_t kBytes = kFormerRecordBytes;

    static constexpr std::optional<SlotName> name(std::span<const std::byte, kBytes> bytes) {
      return RecordSlot::name_of(bytes);
    }
  };
  /// @pre Former::name() trusts the slot in front
  static constexpr void renew(RecordBytes& bytes) {
    bytes = encode(*decode(std::span<const std::byte>(bytes).first(Former::kBytes)));
  }

  static constexpr std::optional<SlotName> name(std::span<const std::byte, kBytes> bytes) {
    return name_of(bytes);
  }

 private:
  static constexpr std::optional<SlotName> name_of(std::span<const std::byte> bytes) {
    const auto record = decode(bytes);
    if (!record) {
      return {};
    }
    return SlotName{record->tendon, record->sequence};
  }
};

/// A parameter block of up to `kLargest` bytes as it is kept in flash, in little-endian words:
/// magic; schema and tendon in a byte each; the number of the write; the size of the block; the
/// block, and zeros; CRC-32 of all before it.
template <std::size_t kLargest, std::uint32_t kSchema>
struct BlockSlot {
  static constexpr std::size_t kHeaderBytes = 16;
  static constexpr std::size_t kBytes = kHeaderBytes + kLargest + 4;
  using Bytes = std::array<std::byte, kBytes>;

  static constexpr std::uint32_t kMagic = 0x53504c54;  ///< "TLPS"
  /// @pre the block has at most kLargest bytes
  static constexpr Bytes make(SlotName name, std::span<const std::byte> block) {
    Bytes bytes{};
    lifemodel::ByteWriter out(bytes);
    out.u32(kMagic);
    out.u32(kSchema | (name.key << 8));
    out.u32(name.sequence);
    out.u32(static_cast<std::uint32_t>(block.size()));
    std::ranges::copy(block, bytes.begin() + kHeaderBytes);
    close(bytes);
    return bytes;
  }

  /// Nothing where the slot cannot be trusted.
  static constexpr std::optional<SlotName> name(std::span<const std::byte, kBytes> bytes) {
    lifemodel::ByteReader in(bytes);
    const bool ours = in.u32() == kMagic;
    const std::uint32_t what = in.u32();
    if (!ours || (what & 0xff) != kSchema ||
        lifemodel::crc32(bytes.first(kBytes - 4)) != lifemodel::ByteReader(bytes.last(4)).u32()) {
      return {};
    }
    const SlotName name{what >> 8, in.u32()};
    if (in.u32() > kLargest) {
      return {};
    }
    return name;
  }

  /// Sets the schema and the CRC.
  static constexpr void close(Bytes& bytes) {
    bytes[4] = static_cast<std::byte>(kSchema);
    lifemodel::ByteWriter(std::span(bytes).last(4))
        .u32(lifemodel::crc32(std::span(bytes).first(kBytes - 4)));
  }

  /// @pre name() trusts the slot
  static constexpr lifemodel::ExtendedBlock block(std::span<const std::byte, kBytes> bytes) {
    const std::uint32_t size = lifemodel::ByteReader(bytes.subspan(kHeaderBytes - 4)).u32();
    return lifemodel::ExtendedBlock(bytes.subspan(kHeaderBytes, size));
  }
};

/// The slot of today. Those of schema 2 were made for blocks of version 1, which are shorter.
template <std::size_t kLargest>
struct ParameterSlot : BlockSlot<kLargest, 3> {
  static constexpr std::size_t kMore = lifemodel::kWatchedBlockBytes - lifemodel::kBlockBytes;
  using Former = BlockSlot<kLargest - kMore, 2>;

  /// @pre Former::name() trusts the slot in front
  static constexpr void renew(typename ParameterSlot::Bytes& bytes) {
    std::fill(bytes.begin() + Former::kBytes - 4, bytes.end(), std::byte{0});
    ParameterSlot::close(bytes);
  }
};

/// The life of `kTendons` tendons in flash; see NewestLog for what a power cut leaves and what a
/// save may cost.
///
/// The memory has to be erased before its first use. A tendon whose very first record, and only
/// that, cannot be read counts as new: it cannot be distinguished from one whose first save was
/// cut.
template <hal::NonVolatile Memory, std::size_t kTendons, FlashLayout kLayout = FlashLayout{}>
class FlashStore {
 public:
  /// Bytes that a parameter block may have.
  static constexpr std::size_t kLargestBlock = kLayout.largest_block;

  explicit FlashStore(Memory& memory) : life_(memory), parameters_(memory), log_(memory) {
    for (std::size_t tendon = 0; tendon < kTendons; ++tendon) {
      const auto bytes = life_.newest(tendon);
      const auto record = bytes ? decode(*bytes) : RecordError::damaged;
      if (record) {
        committed_[tendon] = *record;
      }
      lost_[tendon] = record ? record->past_lost : life_.damaged();
    }
    sequence_ = life_.highest();
    attempted_ = lifemodel::saturating_add(sequence_, life_.spent());
    parameter_writes_ = lifemodel::saturating_add(parameters_.highest(), parameters_.spent());
  }

  [[nodiscard]] std::optional<LifeRecord> load(std::size_t tendon) const {
    return tendon < kTendons ? committed_[tendon] : std::nullopt;
  }

  [[nodiscard]] bool past_lost() const {
    for (const bool lost : lost_) {
      if (lost) {
        return true;
      }
    }
    return false;
  }

  hal::Error save(std::span<const LifeRecord> records) {
    if (!may_follow<kTendons>(records, committed_)) {
      return hal::Error::out_of_range;
    }
    if (attempted_ == std::numeric_limits<std::uint32_t>::max()) {
      return hal::Error::full;
    }
    ++attempted_;
    for (std::size_t tendon = 0; tendon < kTendons; ++tendon) {
      const hal::Error error = save_one(tendon, records[tendon]);
      healthy_ = error == hal::Error::none;
      if (!healthy_) {
        return error;
      }
    }
    sequence_ = attempted_;
    return hal::Error::none;
  }

  [[nodiscard]] std::uint32_t sequence() const { return sequence_; }
  /// False from a save that failed until one that did not.
  [[nodiscard]] bool healthy() const { return healthy_; }

  /// Erases the page that comes next, so that no save has to: for the idle loop, at most one erase
  /// a call.
  hal::Error prepare() { return life_.prepare(); }

  [[nodiscard]] std::optional<lifemodel::ExtendedBlock> load_parameters(std::size_t tendon) {
    if (tendon >= kTendons) {
      return {};
    }
    const auto bytes = parameters_.newest(tendon);
    if (!bytes || !Slot::name(*bytes)) {
      return {};
    }
    return Slot::block(*bytes);
  }
  [[nodiscard]] bool parameters_torn(std::size_t tendon) const {
    return tendon < kTendons && parameters_.torn();
  }

  hal::Error save_parameters(std::size_t tendon, const lifemodel::ExtendedBlock& block) {
    if (tendon >= kTendons || block.bytes().size() > kLargestBlock) {
      return hal::Error::out_of_range;
    }
    if (parameter_writes_ == std::numeric_limits<std::uint32_t>::max()) {
      return hal::Error::full;
    }
    ++parameter_writes_;
    const SlotName name{static_cast<std::uint32_t>(tendon), parameter_writes_};
    return parameters_.append(Slot::make(name, block.bytes()));
  }

  hal::Error append(const LogEntry& entry) { return log_.append(entry); }
  [[nodiscard]] std::optional<LogEntry> log(std::uint32_t i) { return log_.entry(i); }

 private:
  using Slot = ParameterSlot<kLargestBlock>;
  static_assert(kLargestBlock <= lifemodel::kMostExtendedBytes);

  hal::Error save_one(std::size_t tendon, const LifeRecord& given) {
    const LifeRecord record = successor(given, committed_[tendon], lost_[tendon], attempted_);
    const hal::Error error = life_.append(encode(record));
    if (error == hal::Error::none) {
      committed_[tendon] = record;
      lost_[tendon] = record.past_lost;
    }
    return error;
  }

  NewestLog<Memory, RecordSlot, kTendons, kLayout.life> life_;
  NewestLog<Memory, Slot, kTendons, kLayout.parameters> parameters_;
  EntryLog<Memory, kLayout.log> log_;
  Lives<kTendons> committed_{};
  std::array<bool, kTendons> lost_{};
  std::uint32_t sequence_ = 0;
  std::uint32_t attempted_ = 0;  ///< the highest sequence that may have been written
  std::uint32_t parameter_writes_ = 0;
  bool healthy_ = true;
};

}  // namespace storage
