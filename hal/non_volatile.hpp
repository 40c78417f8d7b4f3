#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>

#include "hal/error.hpp"

namespace hal {

/// Memory that keeps its content without power, in pages that are erased whole and written in
/// units once after each erase, as flash is. Addresses count from 0; erased bytes read 0xff.
///
/// program(): exactly kUnitBytes at a multiple of kUnitBytes, into an erased unit; failed where the
/// device says so. A power cut leaves the unit old, new or torn.
/// read(): damaged where a unit in the range is torn or has lost bits beyond correction; the other
/// units of `out` are read all the same, the torn ones as zeros.
template <class T>
concept NonVolatile = requires(T& memory, std::uint32_t address, std::uint32_t page,
                               std::span<const std::byte> in, std::span<std::byte> out) {
  { T::kUnitBytes } -> std::convertible_to<std::size_t>;
  { T::kPageBytes } -> std::convertible_to<std::size_t>;
  { memory.pages() } -> std::convertible_to<std::uint32_t>;
  { memory.erase(page) } -> std::same_as<Error>;
  { memory.program(address, in) } -> std::same_as<Error>;
  { memory.read(address, out) } -> std::same_as<Error>;
};

}  // namespace hal
