#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace lifemodel {

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
