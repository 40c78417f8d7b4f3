#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hal::files {

/// Where bytes come from, read once from the front to the back.
class ByteSource {
 public:
  ByteSource() = default;
  ByteSource(const ByteSource&) = delete;
  ByteSource& operator=(const ByteSource&) = delete;
  virtual ~ByteSource() = default;

  /// Fills the front of `buffer` and returns how many bytes; fewer than asked for is not the end,
  /// 0 is. Throws InputError if reading fails.
  virtual std::size_t read(std::span<char> buffer) = 0;

  /// The size in bytes, 0 if it is not known beforehand.
  virtual std::uint64_t total() const noexcept { return 0; }
};

/// A file, pipe or device; `-` is standard input. Throws InputError if it is missing, unreadable or
/// a directory; `accepted` says in that error what is accepted.
std::unique_ptr<ByteSource> open_source(const std::filesystem::path& path,
                                        std::string_view accepted);

/// Bytes in memory, which must outlive the source.
std::unique_ptr<ByteSource> memory_source(std::string_view bytes);

/// The most bytes of a text that is read as a whole.
inline constexpr std::size_t kMostTextBytes = std::size_t{1} << 20;

/// A whole small file; `-` is standard input. `accepted` says in errors what is accepted.
/// @throws InputError where it cannot be read or is larger than `most_bytes`
std::string read_text_file(const std::filesystem::path& path, std::string_view accepted,
                           std::size_t most_bytes = kMostTextBytes);

/// What stands for the file in errors.
std::string file_name(const std::filesystem::path& path);

/// Gives the lines of a source in constant memory (64 KiB, more for longer lines only): a window of
/// whole lines, each ended by `\n` (the last one of a source that lacks it gets one). A UTF-8 byte
/// order mark at the front is skipped.
class LineBuffer {
 public:
  /// The longest line, with its end, in bytes.
  static constexpr std::size_t kLineLimit = std::size_t{1} << 20;
  static constexpr std::size_t kUsualWindow = std::size_t{1} << 16;

  /// Octets behind lines_end() that may be read, whatever they are.
  static constexpr std::size_t kSpare = 8;

  /// `name` stands for the source in errors, `window` is what is read at once: a power of two times
  /// 1 KiB.
  LineBuffer(std::unique_ptr<ByteSource> source, std::string name,
             std::size_t window = kUsualWindow);

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

  /// Gives the rest of the window away, with the memory that it is in and as much spare behind it;
  /// takes that of `memory` in exchange. Lines are not counted: see set_line_number().
  std::string_view hand_over(std::vector<char>& memory);
  void set_line_number(std::uint64_t number) noexcept { line_number_ = number; }

  /// Bytes of the source before position().
  std::uint64_t bytes_read() const noexcept;
  std::uint64_t bytes_total() const noexcept { return source_->total(); }

 private:
  bool refill();
  void grow();
  void skip_byte_order_mark();
  /// Of the buffer, beside an end of line that is lacking and the spare.
  std::size_t room() const noexcept { return buffer_.size() - 1 - kSpare; }

  std::unique_ptr<ByteSource> source_;
  std::string name_;
  std::vector<char> buffer_;
  const char* position_;
  const char* lines_end_;
  char* data_end_;
  std::uint64_t bytes_before_buffer_ = 0;
  std::uint64_t bytes_from_source_ = 0;
  std::uint64_t line_number_ = 1;
};

}  // namespace hal::files
