#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "firmware/boards/qemu_mps2/semihosting.hpp"

namespace firmware::qemu_mps2 {

/// The command line of the program, split at spaces; the image's path is argument 0. No quoting. A
/// line that is too long gives no arguments at all.
class Arguments {
 public:
  Arguments() {
    const std::size_t size = command_line(line_);
    bool inside = false;
    for (std::size_t i = 0; i < size; ++i) {
      if (line_[i] == ' ') {
        line_[i] = '\0';
        inside = false;
      } else if (!inside && count_ < words_.size()) {
        words_[count_++] = &line_[i];
        inside = true;
      }
    }
  }
  Arguments(const Arguments&) = delete;
  Arguments& operator=(const Arguments&) = delete;

  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] std::span<const char* const> words() const {
    return std::span(words_).first(count_);
  }
  /// Precondition: index < count().
  [[nodiscard]] const char* operator[](std::size_t index) const { return words_[index]; }

 private:
  std::array<char, 1024> line_{};
  std::array<const char*, 16> words_{};
  std::size_t count_ = 0;
};

}  // namespace firmware::qemu_mps2
