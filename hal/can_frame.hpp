#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace hal {

/// A data frame of classic CAN (ISO 11898-1).
struct CanFrame {
  std::uint32_t id = 0;  ///< 11 bits, or 29 where extended
  bool extended = false;
  std::uint8_t length = 0;  ///< 0 .. 8; bytes of `data` past it are zero
  std::array<std::byte, 8> data{};

  [[nodiscard]] constexpr std::span<const std::byte> payload() const {
    return std::span(data).first(length);
  }
  friend constexpr bool operator==(const CanFrame&, const CanFrame&) = default;
};

}  // namespace hal
