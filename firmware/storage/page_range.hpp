#pragma once

#include <cstdint>

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
};

}  // namespace storage
