#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace protocol::e2e {

/// CRC-8H2F of AUTOSAR (CP SWS CRC Library, 7.2.1.2): polynomial 0x2f, initial value and final
/// inversion 0xff, not reflected, check value 0xdf. Four bits a step.
class Crc8h2f {
 public:
  constexpr void add(std::uint8_t byte) {
    remainder_ = step(static_cast<std::uint8_t>(remainder_ ^ byte));
  }
  [[nodiscard]] constexpr std::uint8_t value() const {
    return static_cast<std::uint8_t>(~remainder_);
  }

 private:
  static constexpr std::array<std::uint8_t, 16> kTable = [] {
    std::array<std::uint8_t, 16> table{};
    for (std::uint32_t high = 0; high < 16; ++high) {
      std::uint32_t value = high << 4;
      for (int bit = 0; bit < 4; ++bit) {
        value = (value << 1) ^ ((value & 0x80) != 0 ? 0x2fu : 0u);
      }
      table[high] = static_cast<std::uint8_t>(value);
    }
    return table;
  }();

  static constexpr std::uint8_t step(std::uint8_t value) {
    for (int half = 0; half < 2; ++half) {
      value = static_cast<std::uint8_t>((value << 4) ^ kTable[value >> 4]);
    }
    return value;
  }

  std::uint8_t remainder_ = 0xff;
};

}  // namespace protocol::e2e
