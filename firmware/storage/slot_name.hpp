#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace storage {

/// What tells slots of a log apart: the newest of a key is the one with the highest sequence.
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

}  // namespace storage
