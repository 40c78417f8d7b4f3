#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <span>

namespace hal::slcan {

/// Bytes on their way out, oldest first.
template <std::size_t kBytes>
class ByteQueue {
  static_assert(std::has_single_bit(kBytes));

 public:
  [[nodiscard]] constexpr std::size_t free() const { return kBytes - size_; }
  [[nodiscard]] constexpr bool empty() const { return size_ == 0; }

  /// @pre there is room
  constexpr void push(std::span<const std::byte> bytes) {
    for (const std::byte byte : bytes) {
      bytes_[(first_ + size_++) % kBytes] = byte;
    }
  }
  /// The oldest bytes, as many as lie side by side.
  [[nodiscard]] constexpr std::span<const std::byte> front() const {
    return std::span(bytes_).subspan(first_, std::min(size_, kBytes - first_));
  }
  /// @pre count <= front().size()
  constexpr void pop(std::size_t count) {
    first_ = (first_ + count) % kBytes;
    size_ -= count;
  }

 private:
  std::array<std::byte, kBytes> bytes_{};
  std::size_t first_ = 0;
  std::size_t size_ = 0;
};

}  // namespace hal::slcan
