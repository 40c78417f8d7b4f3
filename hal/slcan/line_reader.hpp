#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "hal/slcan/text.hpp"

namespace hal::slcan {

/// Puts lines together, byte by byte. Line feeds are passed over, so that a terminal can be used.
class LineReader {
 public:
  enum class Event : unsigned char {
    none,     ///< the line goes on
    line,     ///< line() is whole
    too_long  ///< a line has ended that was longer than any can be; it is dropped
  };

  constexpr Event take(std::byte byte) {
    const char c = static_cast<char>(byte);
    if (complete_) {
      complete_ = false;
      size_ = 0;
    }
    if (c == '\n') {
      return Event::none;
    }
    if (c != kEnd) {
      if (size_ < line_.size()) {
        line_[size_] = c;
      }
      size_ += size_ <= line_.size() ? 1 : 0;
      return Event::none;
    }
    complete_ = true;
    return size_ > line_.size() ? Event::too_long : Event::line;
  }

  /// Without its end. Valid after Event::line, until the next byte.
  [[nodiscard]] constexpr std::string_view line() const { return {line_.data(), size_}; }

 private:
  std::array<char, kLongestLine> line_{};
  std::size_t size_ = 0;  ///< one past the capacity where the line is too long
  bool complete_ = false;
};

}  // namespace hal::slcan
