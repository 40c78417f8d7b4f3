#pragma once

#include <cstdint>

#include "firmware/storage/page_range.hpp"

namespace board {

/// Pages of 2 KiB from the start of the flash: 43 of code, one with the node's own settings, 20 of
/// the store. The linker script has the first.
inline constexpr std::uint32_t kFlashPages = 64;
inline constexpr std::uint32_t kNodePage = 43;
inline constexpr std::uint32_t kStorePage = 44;
inline constexpr storage::FlashLayout kStoreLayout{};
inline constexpr std::uint32_t kStorePages = kStoreLayout.log.end();
static_assert(kStorePage + kStorePages == kFlashPages);

}  // namespace board
