#pragma once

#include <cstdint>

namespace lifemodel::extension {

/// Zero error of the current sensor: I - b.
struct CurrentOffset {
  std::int32_t offset = 0;  ///< b in A, Q24

  static constexpr std::int32_t kMost = 1 << 24;
  [[nodiscard]] constexpr bool plausible() const { return offset >= -kMost && offset <= kMost; }
  template <class Word>
  constexpr void words(Word&& word) {
    word(offset);
  }
};

}  // namespace lifemodel::extension
