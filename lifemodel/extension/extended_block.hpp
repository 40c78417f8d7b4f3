#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "lifemodel/block/parameter_block.hpp"
#include "lifemodel/extension/extension.hpp"

namespace lifemodel {

/// A model with what extends it.
struct ExtendedParameters {
  Parameters nominal;
  extension::Extension extension;
};

/// Why the extension of a block is refused.
enum class ExtensionError : std::uint8_t {
  none,
  damaged,          ///< the size, magic or CRC does not fit
  unknown_version,  ///< made for another version of this library
  of_another,       ///< made for another block than the one before it
  unknown_effect,   ///< none, or one that this library does not know
  value,            ///< a value of an effect out of range
};

/// Why a block with or without an extension is refused: at most one of the two.
struct ExtendedBlockError {
  BlockError block = BlockError::none;
  ExtensionError extension = ExtensionError::none;

  [[nodiscard]] constexpr bool refuses() const {
    return block != BlockError::none || extension != ExtensionError::none;
  }
};

/// The reason in words.
constexpr const char* to_string(const ExtendedBlockError& error) {
  switch (error.extension) {
    case ExtensionError::none:
      break;
    case ExtensionError::damaged:
      return "extension damaged: its size, magic or CRC-32 does not fit";
    case ExtensionError::unknown_version:
      return "extension of unknown version: this library reads version 1";
    case ExtensionError::of_another:
      return "extension of another parameter block";
    case ExtensionError::unknown_effect:
      return "extension with an unknown effect";
    case ExtensionError::value:
      return "extension with a value out of range";
  }
  return to_string(error.block);
}

inline constexpr std::uint32_t kExtensionMagic = 0x58504c54;  ///< "TLPX"
inline constexpr std::uint32_t kExtensionVersion = 1;

/// Words of a section that holds no effect: magic, version, bytes of the section, CRC of the block
/// before it, effects, and the CRC-32 of all that last.
inline constexpr std::size_t kEmptyExtensionWords = 6;

/// A section with all effects.
inline constexpr std::size_t kMostExtensionBytes = [] {
  std::size_t words = kEmptyExtensionWords;
  extension::Extension all;
  all.each([&](extension::Effect, auto& part) { part.words([&](std::int32_t&) { ++words; }); });
  return 4 * words;
}();

/// The largest block with all effects.
inline constexpr std::size_t kMostExtendedBytes = kWatchedBlockBytes + kMostExtensionBytes;

/// Writes the block of `p.nominal` and, where there are effects, the section of the extension after
/// it; gives the part of `out` that was used. Without effects it is the block of encode().
/// @pre `out` has kMostExtendedBytes
constexpr std::span<const std::byte> encode(const ExtendedParameters& p, std::span<std::byte> out) {
  const ParameterBlock nominal = encode(p.nominal);
  std::copy(nominal.begin(), nominal.end(), out.begin());
  if (p.extension.effects == 0) {
    return out.first(nominal.size());
  }
  ByteWriter section(out.subspan(nominal.size()));
  section.u32(kExtensionMagic);
  section.u32(kExtensionVersion);
  section.u32(0);
  section.u32(ByteReader(std::span(nominal).last(4)).u32());
  section.u32(p.extension.effects);
  extension::Extension effects = p.extension;
  effects.each([&](extension::Effect effect, auto& part) {
    if (effects.has(effect)) {
      part.words([&](std::int32_t& word) { section.i32(word); });
    }
  });
  const std::size_t bytes = section.size() + 4;
  ByteWriter(out.subspan(nominal.size() + 8)).u32(static_cast<std::uint32_t>(bytes));
  section.u32(crc32(out.subspan(nominal.size(), bytes - 4)));
  return out.first(nominal.size() + bytes);
}

/// The bytes of a block with or without an extension, unchecked.
class ExtendedBlock {
 public:
  constexpr ExtendedBlock() = default;
  /// @pre at most kMostExtendedBytes
  constexpr explicit ExtendedBlock(std::span<const std::byte> bytes) : size_(bytes.size()) {
    std::copy(bytes.begin(), bytes.end(), bytes_.begin());
  }
  constexpr explicit ExtendedBlock(const ExtendedParameters& p) {
    size_ = encode(p, bytes_).size();
  }

  [[nodiscard]] constexpr std::span<const std::byte> bytes() const {
    return std::span(bytes_).first(size_);
  }
  /// The CRC-32 at its end, which tells blocks apart; 0 of what is too short.
  [[nodiscard]] constexpr std::uint32_t crc() const {
    return size_ < 4 ? 0 : ByteReader(bytes().last(4)).u32();
  }

  friend constexpr bool operator==(const ExtendedBlock&, const ExtendedBlock&) = default;

 private:
  std::size_t size_ = 0;
  std::array<std::byte, kMostExtendedBytes> bytes_{};
};

/// Reads the section behind the block with this CRC into `read`, which holds nothing to rely on
/// where it is refused.
constexpr ExtensionError read_extension(std::span<const std::byte> section, std::uint32_t block_crc,
                                        extension::Extension& read) {
  if (section.size() < 4 * kEmptyExtensionWords || section.size() > kMostExtensionBytes ||
      section.size() % 4 != 0) {
    return ExtensionError::damaged;
  }
  ByteReader in(section);
  if (in.u32() != kExtensionMagic) {
    return ExtensionError::damaged;
  }
  if (in.u32() != kExtensionVersion) {
    return ExtensionError::unknown_version;
  }
  if (in.u32() != section.size() ||
      crc32(section.first(section.size() - 4)) != ByteReader(section.last(4)).u32()) {
    return ExtensionError::damaged;
  }
  if (in.u32() != block_crc) {
    return ExtensionError::of_another;
  }
  read = {};
  read.effects = in.u32();
  if (read.effects == 0 || read.effects >> extension::kEffects != 0) {
    return ExtensionError::unknown_effect;
  }
  bool plausible = true;
  read.each([&](extension::Effect effect, auto& part) {
    if (read.has(effect)) {
      part.words([&](std::int32_t& word) { word = in.i32(); });
      plausible = plausible && part.plausible();
    }
  });
  if (in.failed() || in.remaining() != 4) {
    return ExtensionError::damaged;
  }
  return plausible ? ExtensionError::none : ExtensionError::value;
}

/// Checks a block with or without an extension and reads it in place; `out` holds nothing to rely
/// on where it is refused.
constexpr ExtendedBlockError read_extended(std::span<const std::byte> block,
                                           ExtendedParameters& out) {
  const std::span<const std::byte> front =
      block.first(block_bytes(block).value_or(std::min(block.size(), kBlockBytes)));
  const auto nominal = decode(front);
  if (!nominal) {
    return {.block = nominal.error()};
  }
  out.nominal = *nominal;
  if (front.size() == block.size()) {
    out.extension = {};
    return {};
  }
  const std::uint32_t crc = ByteReader(front.last(4)).u32();
  return {.extension = read_extension(block.subspan(front.size()), crc, out.extension)};
}

/// The same by value.
constexpr Result<ExtendedParameters, ExtendedBlockError> decode_extended(
    std::span<const std::byte> block) {
  ExtendedParameters read{};
  const ExtendedBlockError error = read_extended(block, read);
  if (error.refuses()) {
    return error;
  }
  return read;
}

}  // namespace lifemodel
