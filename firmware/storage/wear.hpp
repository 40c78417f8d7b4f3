#pragma once

#include <cstdint>

namespace storage {

/// What pages of flash stand before they wear out, when each is erased as often as the others.
struct Wear {
  std::uint32_t pages = 16;
  std::uint32_t page_bytes = 2'048;
  std::uint32_t record_bytes = 64;
  std::uint32_t erases = 10'000;  ///< a page (STM32G431 data sheet, flash endurance)

  /// Records that can be written in all.
  [[nodiscard]] constexpr std::uint64_t writes() const {
    return std::uint64_t{pages} * (page_bytes / record_bytes) * erases;
  }
  /// Saves of that many tendons, one record each.
  [[nodiscard]] constexpr std::uint64_t saves(std::uint32_t tendons) const {
    return writes() / tendons;
  }
  /// How long that lasts, in tenths of a year of 365.25 days, rounded down.
  [[nodiscard]] constexpr std::uint64_t years_x10(std::uint32_t tendons,
                                                  std::uint32_t seconds_a_save) const {
    constexpr std::uint64_t kTenthOfYear_s = 3'155'760;
    return saves(tendons) * seconds_a_save / kTenthOfYear_s;
  }
};

}  // namespace storage
