#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace lifemodel {

/// Writes little-endian words one after another. The buffer must be large enough for all of them.
class ByteWriter {
 public:
  constexpr explicit ByteWriter(std::span<std::byte> out) : out_(out) {}

  constexpr void u32(std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8) {
      out_[size_++] = static_cast<std::byte>(value >> shift);
    }
  }
  constexpr void i32(std::int32_t value) { u32(static_cast<std::uint32_t>(value)); }
  constexpr void u64(std::uint64_t value) {
    u32(static_cast<std::uint32_t>(value));
    u32(static_cast<std::uint32_t>(value >> 32));
  }
  [[nodiscard]] constexpr std::size_t size() const { return size_; }

 private:
  std::span<std::byte> out_;
  std::size_t size_ = 0;
};

/// Reads little-endian words one after another. Past the end it gives zeros and fails.
class ByteReader {
 public:
  constexpr explicit ByteReader(std::span<const std::byte> in) : in_(in) {}

  constexpr std::uint32_t u32() {
    if (in_.size() - position_ < 4) {
      failed_ = true;
      return 0;
    }
    std::uint32_t value = 0;
    for (int shift = 0; shift < 32; shift += 8) {
      value |= static_cast<std::uint32_t>(in_[position_++]) << shift;
    }
    return value;
  }
  constexpr std::int32_t i32() { return static_cast<std::int32_t>(u32()); }
  constexpr std::uint64_t u64() {
    const std::uint64_t low = u32();
    return low | (std::uint64_t{u32()} << 32);
  }
  [[nodiscard]] constexpr bool failed() const { return failed_; }
  [[nodiscard]] constexpr std::size_t remaining() const { return in_.size() - position_; }

 private:
  std::span<const std::byte> in_;
  std::size_t position_ = 0;
  bool failed_ = false;
};

}  // namespace lifemodel
