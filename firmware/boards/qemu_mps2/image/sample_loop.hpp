#pragma once

#include <array>
#include <cstddef>

#include "firmware/boards/qemu_mps2/image/profile.hpp"

namespace firmware::qemu_mps2 {

/// All samples of a profile in memory, again and again.
class SampleLoop {
 public:
  static constexpr std::size_t kMost = 131'072;

  /// What is wrong, in words; null where nothing is.
  template <class ProfileT>
  const char* fill(ProfileT& profile) {
    while (const auto row = profile.next()) {
      if (size_ == rows_.size()) {
        return "the profile is too long to be held in memory; accepted: 131072 samples";
      }
      rows_[size_++] = *row;
    }
    return size_ == 0 ? "the profile has no samples" : nullptr;
  }

  /// Precondition: filled.
  const Row& isr_next() {
    const Row& row = rows_[at_];
    at_ = at_ + 1 == size_ ? 0 : at_ + 1;
    return row;
  }

 private:
  std::array<Row, kMost> rows_{};
  std::size_t size_ = 0;
  std::size_t at_ = 0;
};

}  // namespace firmware::qemu_mps2
