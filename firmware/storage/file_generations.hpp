#pragma once

#include <fcntl.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "firmware/storage/file_io.hpp"
#include "firmware/storage/life_record.hpp"
#include "lifemodel/extension/extended_block.hpp"
#include "lifemodel/support/bytes.hpp"
#include "lifemodel/support/saturating.hpp"

namespace storage {

/// All that is known of `kTendons` tendons, as one generation of the file of a FileStore.
template <std::size_t kTendons>
struct FileImage {
  std::uint32_t sequence = 0;  ///< of the last save; 0 if there was none
  Lives<kTendons> lives;
  std::array<std::optional<lifemodel::ExtendedBlock>, kTendons> parameters;
  std::array<bool, kTendons> lost{};  ///< as LifeRecord::past_lost, also without a record

  friend bool operator==(const FileImage&, const FileImage&) = default;
};

namespace file_image {

inline constexpr std::uint32_t kMagic = 0x46534c54;  ///< "TLSF"
inline constexpr std::uint32_t kSchema = 3;
inline constexpr std::size_t kHeaderBytes = 16;

/// Where things stand in the part of a tendon, by schema: all that were ever written are read.
struct Layout {
  std::size_t record_bytes;
  bool block_has_size;
  std::size_t block_room;

  [[nodiscard]] constexpr std::size_t block_at() const {
    return 4 + record_bytes + (block_has_size ? 4 : 0);
  }
  [[nodiscard]] constexpr std::size_t tendon_bytes() const { return block_at() + block_room; }
};
inline constexpr std::array<Layout, kSchema> kLayouts{{
    {kFormerRecordBytes, false, lifemodel::kBlockBytes},
    {kFormerRecordBytes, true, lifemodel::kBlockBytes + lifemodel::kMostExtensionBytes},
    {kRecordBytes, true, lifemodel::kMostExtendedBytes},
}};
constexpr bool known(std::uint32_t schema) {
  return schema >= 1 && schema <= kSchema;
}
/// @pre known(schema)
constexpr const Layout& layout(std::uint32_t schema) {
  return kLayouts[schema - 1];
}
inline constexpr std::size_t kBlockAt = layout(kSchema).block_at();
inline constexpr std::size_t kTendonBytes = layout(kSchema).tendon_bytes();
inline constexpr std::uint32_t kHasLife = 1;
inline constexpr std::uint32_t kHasParameters = 2;
inline constexpr std::uint32_t kLost = 4;

constexpr std::size_t size(std::size_t tendons, std::uint32_t schema = kSchema) {
  return kHeaderBytes + tendons * layout(schema).tendon_bytes() + 4;
}
/// Of any controller: more tendons than these have no place on the bus.
inline constexpr std::size_t kMostBytes = size(32);

}  // namespace file_image

/// In little-endian words: magic, schema, number of tendons, sequence; of each tendon what there is
/// (bit 0 a record, 1 parameters, 2 the past was lost), the record, the size of the parameter block
/// and the block in room for the largest, zeros where there is none; CRC-32 of all before it. In
/// schema 2 records have no history of the wire, and there is room for blocks of version 1 alone;
/// in schema 1 besides a block has no size and no extension.
template <std::size_t kTendons>
std::array<std::byte, file_image::size(kTendons)> encode(const FileImage<kTendons>& image) {
  using namespace file_image;
  std::array<std::byte, size(kTendons)> bytes{};
  lifemodel::ByteWriter out(bytes);
  out.u32(kMagic);
  out.u32(kSchema);
  out.u32(kTendons);
  out.u32(image.sequence);
  for (std::size_t tendon = 0; tendon < kTendons; ++tendon) {
    const auto part = std::span(bytes).subspan(kHeaderBytes + tendon * kTendonBytes, kTendonBytes);
    const auto& life = image.lives[tendon];
    const auto& block = image.parameters[tendon];
    lifemodel::ByteWriter(part).u32((life ? kHasLife : 0) | (block ? kHasParameters : 0) |
                                    (image.lost[tendon] ? kLost : 0));
    if (life) {
      std::ranges::copy(encode(*life), part.begin() + 4);
    }
    if (block) {
      lifemodel::ByteWriter(part.subspan(kBlockAt - 4))
          .u32(static_cast<std::uint32_t>(block->bytes().size()));
      std::ranges::copy(block->bytes(), part.begin() + kBlockAt);
    }
  }
  const auto covered = std::span(bytes).first(bytes.size() - 4);
  lifemodel::ByteWriter(std::span(bytes).last(4)).u32(lifemodel::crc32(covered));
  return bytes;
}

/// Why a file was not taken.
struct ImageFault {
  bool foreign;      ///< it is whole, and not for this controller
  std::string what;  ///< and what is accepted
};

template <std::size_t kTendons>
std::variant<FileImage<kTendons>, ImageFault> decode_image(std::span<const std::byte> bytes) {
  using namespace file_image;
  lifemodel::ByteReader in(bytes);
  if (bytes.size() > kMostBytes) {
    return ImageFault{false, "longer than a life file, " + std::to_string(kMostBytes) +
                                 " bytes at most; accepted: a whole life file"};
  }
  if (in.u32() != kMagic) {
    return ImageFault{false, "not a life file; accepted: a file that this controller wrote"};
  }
  const std::uint32_t schema = in.u32();
  const std::uint32_t tendons = in.u32();
  if (bytes.size() < kHeaderBytes + 4 || lifemodel::crc32(bytes.first(bytes.size() - 4)) !=
                                             lifemodel::ByteReader(bytes.last(4)).u32()) {
    return ImageFault{false,
                      "damaged, the CRC-32 at its end does not fit; accepted: a whole life file"};
  }
  if (!known(schema)) {
    return ImageFault{true, "schema " + std::to_string(schema) + "; accepted: schema 1 to " +
                                std::to_string(kSchema)};
  }
  const Layout& layout = file_image::layout(schema);
  if (bytes.size() != size(tendons, schema)) {
    return ImageFault{false, std::to_string(bytes.size()) + " bytes for " +
                                 std::to_string(tendons) +
                                 " tendons; accepted: " + std::to_string(size(tendons, schema))};
  }
  if (tendons != kTendons) {
    return ImageFault{true, "it holds the life of " + std::to_string(tendons) +
                                " tendons; accepted: as many as are configured, " +
                                std::to_string(kTendons)};
  }
  FileImage<kTendons> image;
  image.sequence = in.u32();
  for (std::size_t tendon = 0; tendon < kTendons; ++tendon) {
    const auto part =
        bytes.subspan(kHeaderBytes + tendon * layout.tendon_bytes(), layout.tendon_bytes());
    const std::uint32_t what = lifemodel::ByteReader(part).u32();
    image.lost[tendon] = (what & kLost) != 0;
    if ((what & kHasLife) != 0) {
      const auto life = decode(part.subspan(4, layout.record_bytes));
      if (!life || life->tendon != tendon || life->sequence > image.sequence) {
        return ImageFault{false, "the record of tendon " + std::to_string(tendon) + " is " +
                                     (life ? "of another" : to_string(life.error())) +
                                     "; accepted: a record of this tendon"};
      }
      image.lives[tendon] = *life;
    }
    if ((what & kHasParameters) != 0) {
      const std::size_t block_bytes =
          layout.block_has_size ? lifemodel::ByteReader(part.subspan(layout.block_at() - 4)).u32()
                                : layout.block_room;
      if (block_bytes > layout.block_room) {
        return ImageFault{false, "the parameter block of tendon " + std::to_string(tendon) +
                                     " has " + std::to_string(block_bytes) + " bytes; accepted: " +
                                     std::to_string(layout.block_room) + " at most"};
      }
      image.parameters[tendon] =
          lifemodel::ExtendedBlock(part.subspan(layout.block_at(), block_bytes));
    }
  }
  return image;
}

/// The newest image of a folder and the one before: the files `life` and `life.previous`.
///
/// A new image is written beside them, synced and then renamed, and the folder is synced: whenever
/// the power goes, one of the two files is a whole image and at least as new as the last one that
/// was committed. A damaged file is kept as `life.damaged` and never takes the place of a good one.
template <std::size_t kTendons, FileCalls Calls>
class FileGenerations {
 public:
  using Image = FileImage<kTendons>;

  struct Loaded {
    Image image;
    std::vector<FileError> notices;  ///< what was damaged
  };

  FileGenerations(Calls calls, std::string folder)
      : calls_(calls), life_(std::move(folder) + "/life") {}

  /// The newest image that is whole, a blank one where there is no file.
  std::variant<Loaded, FileError> load() {
    Loaded result;
    auto newest = load_file(life_);
    if (auto* error = std::get_if<FileError>(&newest)) {
      return std::move(*error);
    }
    File& life = std::get<File>(newest);
    if (life.image) {
      result.image = *life.image;
      return result;
    }
    damaged_ = life.damage.has_value();
    auto older = load_file(previous());
    if (auto* error = std::get_if<FileError>(&older)) {
      return std::move(*error);
    }
    File& before = std::get<File>(older);
    note(result, life, before);
    if (before.image) {
      result.image = *before.image;
      // The damaged file was one save ahead.
      result.image.sequence = lifemodel::saturating_add(result.image.sequence, damaged_ ? 1u : 0u);
    } else if (damaged_ || before.damage) {
      result.image.lost.fill(true);
    }
    return result;
  }

  /// Makes `image` the newest. Nothing where it is committed; else the files are as they were, or
  /// the next load() finds either.
  std::optional<FileError> store(const Image& image, int folder_fd) {
    const std::string partial = life_ + ".partial";
    if (const Errno error = write_partial(partial, image); error != 0) {
      return failure(partial, "write", error);
    }
    const std::string aside = damaged_ ? life_ + ".damaged" : previous();
    if (calls_.rename(life_.c_str(), aside.c_str()) != 0 && errno != ENOENT) {
      return failure(life_, "rename", errno);
    }
    damaged_ = false;
    if (calls_.rename(partial.c_str(), life_.c_str()) != 0) {
      return failure(partial, "rename", errno);
    }
    if (calls_.fsync(folder_fd) != 0) {
      return failure(life_, "sync the folder of", errno);
    }
    return {};
  }

 private:
  /// Neither where there is no file.
  struct File {
    std::optional<Image> image;
    std::optional<std::string> damage;
  };

  [[nodiscard]] std::string previous() const { return life_ + ".previous"; }

  static FileError failure(const std::string& path, const char* what, Errno error) {
    return {path, std::string("cannot ") + what + " it: " + std::strerror(error)};
  }

  std::variant<File, FileError> load_file(const std::string& path) {
    const FileHandle<Calls> file(calls_, path, O_RDONLY);
    if (file.error() == ENOENT) {
      return File{};
    }
    if (file.error() != 0) {
      return failure(path, "open", file.error());
    }
    const auto read = read_up_to(calls_, file.get(), file_image::kMostBytes + 1);
    if (const Errno* error = std::get_if<Errno>(&read)) {
      return failure(path, "read", *error);
    }
    const auto decoded = decode_image<kTendons>(std::get<std::vector<std::byte>>(read));
    if (const auto* image = std::get_if<Image>(&decoded)) {
      return File{*image, {}};
    }
    const auto& fault = std::get<ImageFault>(decoded);
    if (fault.foreign) {
      return FileError{path, fault.what};
    }
    return File{{}, fault.what};
  }

  void note(Loaded& result, const File& life, const File& before) const {
    if (life.damage) {
      result.notices.push_back(
          {life_, *life.damage + (before.image ? "; the save before is used"
                                               : "; there is no save before to use")});
    }
    if (before.damage) {
      result.notices.push_back({previous(), *before.damage});
    }
  }

  Errno write_partial(const std::string& path, const Image& image) {
    FileHandle<Calls> file(calls_, path, O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW);
    if (file.error() != 0) {
      return file.error();
    }
    const auto bytes = encode(image);
    if (const Errno error = write_all(calls_, file.get(), bytes, 0); error != 0) {
      return error;
    }
    if (calls_.fsync(file.get()) != 0) {
      return errno;
    }
    return file.close();
  }

  Calls calls_;
  std::string life_;
  bool damaged_ = false;
};

}  // namespace storage
