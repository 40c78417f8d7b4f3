#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace app::fuzz {

/// The bytes of one input, one after another; zeros past the end.
class Input {
 public:
  Input(const std::uint8_t* data, std::size_t size) : left_(data, size) {}

  [[nodiscard]] bool empty() const { return left_.empty(); }
  std::uint8_t byte() {
    if (left_.empty()) {
      return 0;
    }
    const std::uint8_t first = left_.front();
    left_ = left_.subspan(1);
    return first;
  }
  std::uint32_t word() {
    std::uint32_t value = 0;
    for (int i = 0; i < 4; ++i) {
      value = value << 8 | byte();
    }
    return value;
  }
  void fill(std::span<std::byte> out) {
    for (std::byte& one : out) {
      one = std::byte{byte()};
    }
  }

 private:
  std::span<const std::uint8_t> left_;
};

}  // namespace app::fuzz
