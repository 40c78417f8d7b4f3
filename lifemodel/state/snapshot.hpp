#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "lifemodel/support/bytes.hpp"

namespace lifemodel {

inline constexpr std::uint32_t kSnapshotMagic = 0x4e534c54;  ///< "TLSN"
inline constexpr std::uint32_t kSnapshotVersion = 1;

/// Why a snapshot is refused. The estimator then keeps the state that it had.
enum class SnapshotError : std::uint8_t {
  none,
  wrong_size,       ///< longer or shorter than it says
  not_a_snapshot,   ///< other magic
  unknown_version,  ///< written by another version of this library
  damaged,          ///< the CRC does not fit
  other_tendons,    ///< another number of tendons
  other_model,      ///< written under other parameters
  implausible,      ///< a state that no count could have left, or too large for this layout
};

/// The reason in words.
constexpr const char* to_string(SnapshotError error) {
  switch (error) {
    case SnapshotError::none:
      return "accepted";
    case SnapshotError::wrong_size:
      return "wrong size: longer or shorter than the snapshot says";
    case SnapshotError::not_a_snapshot:
      return "not a snapshot";
    case SnapshotError::unknown_version:
      return "unknown version: this library reads version 1";
    case SnapshotError::damaged:
      return "damaged: the CRC-32 does not fit";
    case SnapshotError::other_tendons:
      return "written for another number of tendons";
    case SnapshotError::other_model:
      return "written under other parameters";
    case SnapshotError::implausible:
      return "a state that no count could have left";
  }
  return "unknown";
}

/// Whether a state may continue under parameters other than those it was written under. What was
/// counted stays as it is, what is still open is then counted under the new ones.
enum class ModelChange : std::uint8_t { refuse, allow };

/// Header of a snapshot: magic, version, size in bytes with the CRC, number of tendons.
inline constexpr std::size_t kSnapshotHeaderBytes = 16;

/// Checks the frame of a snapshot: size, magic, version, CRC and number of tendons.
constexpr SnapshotError check_snapshot(std::span<const std::byte> bytes, std::uint32_t tendons) {
  if (bytes.size() < kSnapshotHeaderBytes + 4) {
    return SnapshotError::wrong_size;
  }
  ByteReader in(bytes);
  if (in.u32() != kSnapshotMagic) {
    return SnapshotError::not_a_snapshot;
  }
  if (in.u32() != kSnapshotVersion) {
    return SnapshotError::unknown_version;
  }
  if (in.u32() != bytes.size()) {
    return SnapshotError::wrong_size;
  }
  if (crc32(bytes.first(bytes.size() - 4)) != ByteReader(bytes.last(4)).u32()) {
    return SnapshotError::damaged;
  }
  return in.u32() == tendons ? SnapshotError::none : SnapshotError::other_tendons;
}

}  // namespace lifemodel
