#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "hal/error.hpp"
#include "hal/non_volatile.hpp"
#include "lifemodel/extension/extended_block.hpp"

namespace storage {

/// Pages of a memory that follow one another.
struct PageRange {
  std::uint32_t first = 0;
  std::uint32_t count = 0;

  [[nodiscard]] constexpr std::uint32_t end() const { return first + count; }
};

/// What is kept where. The defaults are 20 pages of an STM32G431.
struct FlashLayout {
  PageRange life{0, 16};
  PageRange parameters{16, 2};
  PageRange log{18, 2};
  std::size_t largest_block = lifemodel::kMostExtendedBytes;
};

/// What distinguishes slots of a log: the newest of a key is the one with the highest sequence.
struct SlotName {
  std::uint32_t key = 0;
  std::uint32_t sequence = 0;

  friend constexpr bool operator==(const SlotName&, const SlotName&) = default;
};

/// How things are laid out in slots of kBytes, their CRC last. name(): nothing where the slot
/// cannot be trusted.
template <class T>
concept SlotFormat = requires(std::span<const std::byte, T::kBytes> bytes) {
  { T::kBytes } -> std::convertible_to<std::size_t>;
  { T::name(bytes) } -> std::same_as<std::optional<SlotName>>;
};

/// A format that took the place of another one, its Former, slots of which are still read: renew()
/// makes a slot of this one where it stands, of one of it that Former::name() trusts.
template <class T>
concept SucceedingFormat = SlotFormat<T> && SlotFormat<typename T::Former> && T::Former::kBytes <=
                           T::kBytes&& requires(std::array<std::byte, T::kBytes>& bytes) {
  { T::renew(bytes) } -> std::same_as<void>;
};

/// Bytes that `bytes` take up in units of the memory.
template <hal::NonVolatile Memory>
constexpr std::uint32_t slot_stride(std::size_t bytes) {
  constexpr std::size_t kUnit = Memory::kUnitBytes;
  return static_cast<std::uint32_t>((bytes + kUnit - 1) / kUnit * kUnit);
}

/// Whether a number of bytes at `address`, whole units, can be read and are erased.
template <hal::NonVolatile Memory>
bool is_blank(Memory& memory, std::uint32_t address, std::uint32_t bytes) {
  std::array<std::byte, Memory::kUnitBytes> unit;
  for (std::uint32_t offset = 0; offset < bytes; offset += Memory::kUnitBytes) {
    if (memory.read(address + offset, unit) != hal::Error::none ||
        !std::ranges::all_of(unit, [](std::byte b) { return b == std::byte{0xff}; })) {
      return false;
    }
  }
  return true;
}

/// Programs a slot unit by unit, so that its last bytes, the CRC, come last; then reads it back.
/// failed where it does not read back the same.
template <hal::NonVolatile Memory, std::size_t kBytes>
hal::Error write_slot(Memory& memory, std::uint32_t address,
                      std::span<const std::byte, kBytes> bytes) {
  constexpr std::uint32_t kUnit = Memory::kUnitBytes;
  for (std::uint32_t offset = 0; offset < kBytes; offset += kUnit) {
    std::array<std::byte, kUnit> unit;
    unit.fill(std::byte{0xff});
    std::ranges::copy(bytes.subspan(offset, std::min<std::size_t>(kUnit, kBytes - offset)),
                      unit.begin());
    const hal::Error error = memory.program(address + offset, unit);
    if (error != hal::Error::none) {
      return error;
    }
  }
  for (std::uint32_t offset = 0; offset < kBytes; offset += kUnit) {
    std::array<std::byte, kUnit> unit;
    const auto wanted = bytes.subspan(offset, std::min<std::size_t>(kUnit, kBytes - offset));
    if (memory.read(address + offset, unit) != hal::Error::none ||
        !std::equal(wanted.begin(), wanted.end(), unit.begin())) {
      return hal::Error::failed;
    }
  }
  return hal::Error::none;
}

}  // namespace storage
