#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace host_sim {

/// Splits one line of CSV (RFC 4180, without its line end; also with another delimiter) into
/// fields.
class CsvLine {
 public:
  explicit CsvLine(std::string_view line, char delimiter = ',')
      : line_(line), delimiter_(delimiter) {}

  /// Goes to the next field; false after the last one.
  bool next();

  /// The field without its quotes.
  const std::string& text() const noexcept { return text_; }

  /// Where the field starts in the line, in bytes.
  std::size_t offset() const noexcept { return offset_; }

  /// Whether the field's quotes are wrong: not closed on this line, or followed by text.
  bool broken() const noexcept { return broken_; }

 private:
  void read_quoted();

  std::string_view line_;
  char delimiter_;
  std::size_t next_ = 0;
  std::size_t offset_ = 0;
  std::string text_;
  bool broken_ = false;
  bool at_end_ = false;
};

}  // namespace host_sim
