#pragma once

#include <array>
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

/// CRC-32/ISO-HDLC (IEEE 802.3: reflected polynomial 0xEDB88320, check value 0xCBF43926), four bits
/// a step.
constexpr std::uint32_t crc32(std::span<const std::byte> bytes) {
  constexpr std::array<std::uint32_t, 16> kTable = [] {
    std::array<std::uint32_t, 16> table{};
    for (std::uint32_t i = 0; i < 16; ++i) {
      std::uint32_t value = i;
      for (int bit = 0; bit < 4; ++bit) {
        value = (value >> 1) ^ ((value & 1u) != 0 ? 0xEDB88320u : 0u);
      }
      table[i] = value;
    }
    return table;
  }();
  std::uint32_t crc = 0xffffffffu;
  for (const std::byte byte : bytes) {
    crc ^= static_cast<std::uint32_t>(byte);
    crc = (crc >> 4) ^ kTable[crc & 15u];
    crc = (crc >> 4) ^ kTable[crc & 15u];
  }
  return ~crc;
}

}  // namespace lifemodel
