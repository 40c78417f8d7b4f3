#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "hal/error.hpp"
#include "hal/stm32g4/flash_operations.hpp"

namespace hal::stm32g4 {

/// hal::NonVolatile on some pages of the flash. `OperationsT` has the members erase(), program()
/// and read() of FlashOperations.
template <class OperationsT>
class FlashMemory {
 public:
  static constexpr std::size_t kUnitBytes = 8;
  static constexpr std::size_t kPageBytes = 2048;

  /// `pages` pages from `first_page` on, counted from the start of the flash.
  FlashMemory(OperationsT& operations, std::uint32_t first_page, std::uint32_t pages)
      : operations_(operations), first_page_(first_page), pages_(pages) {}

  [[nodiscard]] std::uint32_t pages() const { return pages_; }

  Error erase(std::uint32_t page) {
    return page < pages_ ? operations_.erase(first_page_ + page) : Error::out_of_range;
  }

  Error program(std::uint32_t address, std::span<const std::byte> in) {
    if (in.size() != kUnitBytes || address % kUnitBytes != 0 || !contains(address, kUnitBytes)) {
      return Error::out_of_range;
    }
    const DoubleWord value{word(in.first(4)), word(in.last(4))};
    DoubleWord now{};
    // All zeros can be programmed over anything (RM0440 5.3.7), which is not what was agreed.
    if (!operations_.read(offset(address), now) || (now.low & now.high) != 0xFFFFFFFFu) {
      return Error::failed;
    }
    return operations_.program(offset(address), value);
  }

  Error read(std::uint32_t address, std::span<std::byte> out) {
    if (!contains(address, out.size())) {
      return Error::out_of_range;
    }
    Error result = Error::none;
    for (std::size_t done = 0; done < out.size();) {
      const auto place = static_cast<std::uint32_t>(address + done);
      const std::uint32_t within = place % kUnitBytes;
      const std::size_t count = std::min<std::size_t>(kUnitBytes - within, out.size() - done);
      DoubleWord value{};
      if (!operations_.read(offset(place - within), value)) {
        result = Error::damaged;
      }
      for (std::size_t i = 0; i < count; ++i) {
        out[done + i] = byte_of(value, within + i);
      }
      done += count;
    }
    return result;
  }

 private:
  [[nodiscard]] bool contains(std::uint32_t address, std::size_t count) const {
    const std::size_t size = pages_ * kPageBytes;
    return address <= size && count <= size - address;
  }
  [[nodiscard]] std::uint32_t offset(std::uint32_t address) const {
    return first_page_ * static_cast<std::uint32_t>(kPageBytes) + address;
  }
  static std::uint32_t word(std::span<const std::byte> bytes) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      value |= std::to_integer<std::uint32_t>(bytes[i]) << (8 * i);
    }
    return value;
  }
  static std::byte byte_of(DoubleWord value, std::size_t index) {
    return static_cast<std::byte>((index < 4 ? value.low : value.high) >> (8 * (index % 4)));
  }

  OperationsT& operations_;
  std::uint32_t first_page_;
  std::uint32_t pages_;
};

}  // namespace hal::stm32g4
