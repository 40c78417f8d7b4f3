#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace board {

/// The 96 bits that no other device has (RM0440 48.1).
inline std::array<std::byte, 12> unique_id() {
  constexpr std::uintptr_t kUniqueId = 0x1FFF7590;
  const auto* bytes = reinterpret_cast<const volatile std::uint8_t*>(kUniqueId);
  std::array<std::byte, 12> id{};
  for (std::size_t i = 0; i < id.size(); ++i) {
    id[i] = static_cast<std::byte>(bytes[i]);
  }
  return id;
}

}  // namespace board
