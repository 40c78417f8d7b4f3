#pragma once

#include <concepts>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hal::files {

/// What stands between the fields of a file.
struct CsvDialect {
  char delimiter = ',';
  bool blanks = false;  ///< may stand in front of a field
};

/// By the header of a file: tabs or else semicolons where one stands outside of quotes, or else
/// commas; blanks where one stands behind such a delimiter.
CsvDialect dialect_of(std::string_view header);

/// Splits one line of CSV (RFC 4180, without its line end, in any dialect) into fields.
class CsvLine {
 public:
  explicit CsvLine(std::string_view line, CsvDialect dialect = {})
      : line_(line), dialect_(dialect) {}

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
  CsvDialect dialect_;
  std::size_t next_ = 0;
  std::size_t offset_ = 0;
  std::string text_;
  bool broken_ = false;
  bool at_end_ = false;
};

/// The finite decimal number that a field holds, and nothing else; none if it holds any other.
std::optional<double> finite_number(std::string_view field);

/// What a field holds that should be a number and is none, and what is accepted.
struct NoNumber {
  std::string found;
  std::string accepted;
};

/// @pre finite_number() gives none
NoNumber no_number(std::string_view field, const CsvDialect& dialect);

/// A line of CSV (RFC 4180) that is put together field by field.
class CsvRow {
 public:
  /// Text in quotes where it needs them, made printable.
  void add(std::string_view text);
  void add(const char* text) { add(std::string_view(text)); }
  void add(std::unsigned_integral auto count) { fields_.push_back(std::to_string(count)); }
  /// The shortest decimal that reads back as `value`; nothing for NaN, `inf` for infinity.
  void add(double value);
  /// Empty fields until there are `count`.
  void fill_to(std::size_t count) { fields_.resize(count); }

  /// With the end of the line.
  [[nodiscard]] std::string line() const;

 private:
  std::vector<std::string> fields_;
};

/// The header line of these columns.
std::string csv_head(std::span<const std::string_view> columns);

}  // namespace hal::files
