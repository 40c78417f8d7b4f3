#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "host_sim/io/byte_source.hpp"

namespace host_sim {

/// Gives the lines of a source in constant memory (64 KiB, more for longer lines only): a window of
/// whole lines, each ended by `\n` (the last one of a source that lacks it gets one). A UTF-8 byte
/// order mark at the front is skipped.
class LineBuffer {
 public:
  /// The longest line, with its end, in bytes.
  static constexpr std::size_t kLineLimit = std::size_t{1} << 20;

  /// `name` stands for the source in errors.
  LineBuffer(std::unique_ptr<ByteSource> source, std::string name);

  /// Makes sure that a whole line is at position(); false at the end. Throws InputError for a line
  /// over the limit.
  bool fill() { return position_ != lines_end_ || refill(); }

  /// The rest of the window: the start of a line, and the end of the last whole line.
  const char* position() const noexcept { return position_; }
  const char* lines_end() const noexcept { return lines_end_; }

  /// The end of this line: its `\n`.
  const char* line_end() const noexcept;

  /// This line without its end, be it `\n` or `\r\n`.
  std::string_view line() const noexcept;

  /// The number of this line, from 1.
  std::uint64_t line_number() const noexcept { return line_number_; }

  /// Goes behind the `\n` at `line_end`.
  void next_line(const char* line_end) noexcept {
    position_ = line_end + 1;
    ++line_number_;
  }

  /// Bytes of the source before position().
  std::uint64_t bytes_read() const noexcept;
  std::uint64_t bytes_total() const noexcept { return source_->total(); }

 private:
  bool refill();
  void grow();
  void skip_byte_order_mark();

  std::unique_ptr<ByteSource> source_;
  std::string name_;
  std::vector<char> buffer_;  ///< one byte more than is read, for an end of line that is lacking
  const char* position_;
  const char* lines_end_;
  char* data_end_;
  std::uint64_t bytes_before_buffer_ = 0;
  std::uint64_t bytes_from_source_ = 0;
  std::uint64_t line_number_ = 1;
};

}  // namespace host_sim
