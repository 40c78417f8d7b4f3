#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "firmware/storage/slot_name.hpp"
#include "lifemodel/block/parameter_block.hpp"
#include "lifemodel/support/bytes.hpp"
#include "lifemodel/support/crc32.hpp"

namespace storage {

/// A parameter block as it is kept in flash, in little-endian words: magic; schema and tendon in a
/// byte each; the number of the write; the block; a word of zeros; CRC-32 of all before it.
struct ParameterSlot {
  static constexpr std::size_t kHeaderBytes = 12;
  static constexpr std::size_t kBytes = kHeaderBytes + lifemodel::kBlockBytes + 8;
  using Bytes = std::array<std::byte, kBytes>;

  static constexpr std::uint32_t kMagic = 0x53504c54;  ///< "TLPS"
  static constexpr std::uint32_t kSchema = 1;

  static constexpr Bytes make(SlotName name, const lifemodel::ParameterBlock& block) {
    Bytes bytes{};
    lifemodel::ByteWriter out(bytes);
    out.u32(kMagic);
    out.u32(kSchema | (name.key << 8));
    out.u32(name.sequence);
    std::ranges::copy(block, bytes.begin() + kHeaderBytes);
    lifemodel::ByteWriter(std::span(bytes).last(4))
        .u32(lifemodel::crc32(std::span(bytes).first(kBytes - 4)));
    return bytes;
  }

  /// Nothing where the slot cannot be trusted.
  static constexpr std::optional<SlotName> name(std::span<const std::byte, kBytes> bytes) {
    lifemodel::ByteReader in(bytes);
    if (in.u32() != kMagic ||
        lifemodel::crc32(bytes.first(kBytes - 4)) != lifemodel::ByteReader(bytes.last(4)).u32()) {
      return {};
    }
    const std::uint32_t what = in.u32();
    if ((what & 0xff) != kSchema) {
      return {};
    }
    return SlotName{what >> 8, in.u32()};
  }

  static constexpr lifemodel::ParameterBlock block(std::span<const std::byte, kBytes> bytes) {
    lifemodel::ParameterBlock block{};
    std::ranges::copy(bytes.subspan(kHeaderBytes, lifemodel::kBlockBytes), block.begin());
    return block;
  }
};

}  // namespace storage
