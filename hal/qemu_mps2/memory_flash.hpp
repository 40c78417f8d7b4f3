#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>

#include "hal/error.hpp"

namespace hal::qemu_mps2 {

/// Where the content of a MemoryFlash outlives the program.
///
/// load(): fills all of `out` with what was kept; false where nothing was, or not as much.
/// keep(): replaces the bytes from `address` on; false where that failed.
template <class T>
concept Backing = requires(T& backing, std::uint32_t address, std::span<std::byte> out,
                           std::span<const std::byte> in) {
  { backing.load(out) } -> std::same_as<bool>;
  { backing.keep(address, in) } -> std::same_as<bool>;
};

/// For content that ends with the program.
struct NoBacking {
  static bool load(std::span<std::byte>) { return false; }
  static bool keep(std::uint32_t, std::span<const std::byte>) { return true; }
};

/// Flash in memory with the geometry and the rules of an STM32G4 (RM0440, 3.3.7 and 3.3.8): pages
/// of 2 KiB, double words that are programmed once. What is kept elsewhere follows each operation.
template <std::uint32_t kPages, Backing BackingT = NoBacking>
class MemoryFlash {
 public:
  static constexpr std::size_t kUnitBytes = 8;
  static constexpr std::size_t kPageBytes = 2048;
  static constexpr std::uint32_t kBytes = kPages * kPageBytes;

  /// With the content that was kept, or erased where there was none.
  explicit MemoryFlash(BackingT& backing) : backing_(backing) {
    if (!backing_.load(memory_)) {
      memory_.fill(kErased);
    }
  }

  [[nodiscard]] static constexpr std::uint32_t pages() { return kPages; }

  Error erase(std::uint32_t page) {
    if (page >= kPages) {
      return Error::out_of_range;
    }
    const auto address = static_cast<std::uint32_t>(page * kPageBytes);
    const auto bytes = std::span(memory_).subspan(address, kPageBytes);
    std::ranges::fill(bytes, kErased);
    return backing_.keep(address, bytes) ? Error::none : Error::failed;
  }

  Error program(std::uint32_t address, std::span<const std::byte> in) {
    if (in.size() != kUnitBytes || address % kUnitBytes != 0 || address > kBytes - kUnitBytes) {
      return Error::out_of_range;
    }
    const auto unit = std::span(memory_).subspan(address, kUnitBytes);
    if (!std::ranges::all_of(unit, [](std::byte byte) { return byte == kErased; })) {
      return Error::failed;
    }
    std::ranges::copy(in, unit.begin());
    return backing_.keep(address, unit) ? Error::none : Error::failed;
  }

  Error read(std::uint32_t address, std::span<std::byte> out) {
    if (address > kBytes || out.size() > kBytes - address) {
      return Error::out_of_range;
    }
    std::ranges::copy(std::span(memory_).subspan(address, out.size()), out.begin());
    return Error::none;
  }

  /// All of it.
  [[nodiscard]] std::span<const std::byte> content() const { return memory_; }

 private:
  static constexpr std::byte kErased{0xff};

  BackingT& backing_;
  std::array<std::byte, kBytes> memory_{};
};

}  // namespace hal::qemu_mps2
