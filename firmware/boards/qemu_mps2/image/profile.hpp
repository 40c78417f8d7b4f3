#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "firmware/boards/qemu_mps2/image/format.hpp"
#include "firmware/boards/qemu_mps2/image/source.hpp"
#include "lifemodel/support/bytes.hpp"

namespace firmware::qemu_mps2 {

using Row = std::array<std::int32_t, kTendons>;

/// Reads the samples of a recording, many at a time.
template <Source SourceT>
class Profile {
 public:
  explicit Profile(SourceT& source) : source_(source) {}

  /// What is wrong with the file, in words; null where nothing is. Before all else.
  const char* open() {
    std::array<std::byte, ProfileHeader::kBytes> bytes{};
    if (source_.read(bytes) != bytes.size()) {
      return "the profile is shorter than its header of 16 bytes";
    }
    lifemodel::ByteReader in(bytes);
    if (in.u32() != ProfileHeader::kMagic) {
      return "the profile does not begin with TLPF";
    }
    if (in.u32() != ProfileHeader::kVersion) {
      return "the profile is of another version; accepted: 1";
    }
    if (in.u32() != kTendons) {
      return "the profile is for another number of tendons; accepted: 2";
    }
    period_us_ = in.u32();
    if (period_us_ < kShortestPeriod_us || period_us_ > kLongestPeriod_us) {
      return "the sample period of the profile is out of range; accepted: 10 .. 1000 us";
    }
    return nullptr;
  }

  [[nodiscard]] std::uint32_t sample_period_us() const { return period_us_; }

  /// The next sample of all tendons; nothing at the end.
  std::optional<Row> next() {
    if (at_ == size_) {
      size_ = source_.read(chunk_) / kRowBytes * kRowBytes;
      at_ = 0;
    }
    if (at_ == size_) {
      return std::nullopt;
    }
    lifemodel::ByteReader in{std::span(chunk_).subspan(at_, kRowBytes)};
    at_ += kRowBytes;
    Row row{};
    for (std::int32_t& sample : row) {
      sample = in.i32();
    }
    return row;
  }

 private:
  static constexpr std::size_t kRowBytes = 4 * kTendons;

  SourceT& source_;
  std::array<std::byte, 512 * kRowBytes> chunk_{};
  std::size_t size_ = 0;
  std::size_t at_ = 0;
  std::uint32_t period_us_ = 0;
};

}  // namespace firmware::qemu_mps2
