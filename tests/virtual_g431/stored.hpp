#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "firmware/storage/flash_store.hpp"
#include "hal/error.hpp"
#include "tests/virtual_g431/board/flash.hpp"

namespace virtual_g431 {

/// hal::NonVolatile on the pages of the store in the flash of a board that is off.
class StoreMemory {
 public:
  static constexpr std::size_t kUnitBytes = 8;
  static constexpr std::size_t kPageBytes = virtual_g431::kPageBytes;

  explicit StoreMemory(FlashContents& contents) : contents_(contents) {}

  static std::uint32_t pages() { return 20; }
  hal::Error erase(std::uint32_t page) {
    const std::array<std::uint8_t, kPageBytes> erased = [] {
      std::array<std::uint8_t, kPageBytes> bytes{};
      bytes.fill(0xFF);
      return bytes;
    }();
    contents_.flash(at(page * kPageBytes), erased);
    return hal::Error::none;
  }
  hal::Error program(std::uint32_t address, std::span<const std::byte> in) {
    std::transform(in.begin(), in.end(), contents_.bytes.begin() + at(address),
                   [](std::byte byte) { return std::to_integer<std::uint8_t>(byte); });
    return hal::Error::none;
  }
  hal::Error read(std::uint32_t address, std::span<std::byte> out) {
    hal::Error error = hal::Error::none;
    for (std::size_t i = 0; i < out.size(); ++i) {
      const std::size_t place = at(static_cast<std::uint32_t>(address + i));
      const bool damaged = contents_.damaged.test(place / 8);
      error = damaged ? hal::Error::damaged : error;
      out[i] = damaged ? std::byte{0} : static_cast<std::byte>(contents_.bytes[place]);
    }
    return error;
  }

 private:
  static constexpr std::uint32_t at(std::size_t address) {
    return 44 * kPageBytes + static_cast<std::uint32_t>(address);
  }
  FlashContents& contents_;
};

/// The life that a restart would find.
inline std::optional<storage::LifeRecord> stored_life(FlashContents& contents) {
  StoreMemory memory(contents);
  return storage::FlashStore<StoreMemory, 1>(memory).load(0);
}

}  // namespace virtual_g431
