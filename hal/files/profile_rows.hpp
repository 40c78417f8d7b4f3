#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "hal/files/input_error.hpp"
#include "hal/files/input_file.hpp"
#include "hal/files/plain_decimal.hpp"
#include "hal/files/profile_columns.hpp"
#include "hal/files/text.hpp"

namespace hal::files {

/// Reads a header line; throws InputError for columns that are not accepted.
using ProfileHeaderParser = std::function<ProfileLayout(const TextPlace&)>;

/// Reads up to the first row and gives the layout. `name` stands for the file in errors,
/// `accepted` says in the error for an empty file what is accepted.
ProfileLayout read_profile_header(LineBuffer& lines, std::string_view name,
                                  std::string_view accepted, const ProfileHeaderParser& layout_of);

/// Throws InputError for a line that is no text.
void refuse_nul(const TextPlace& line);

/// Reads single rows of a profile: all of its columns, finite, within the ranges of
/// profile_columns() and with strictly increasing time.
class ProfileRowParser {
 public:
  /// By ProfileColumnId, and a 0 behind them; 0 where the file lacks the column.
  using Values = std::array<double, kProfileColumnCount + 1>;

  explicit ProfileRowParser(ProfileLayout layout);

  const ProfileLayout& layout() const noexcept { return layout_; }

  /// The common row: numbers, quoted or not, all right, and later than `last_time_s`. Gives the end
  /// of its line, or nullptr for any other row.
  /// @pre lines up to `end`, and kPlainDecimalReach octets behind it, can be read
  const char* plain(const char* at, const char* end, double last_time_s, Values& values) const {
    const CsvDialect dialect = layout_.dialect;
    const Column* const last = &columns_.back();
    for (const Column* column = columns_.data();; ++column) {
      while (dialect.blanks && *at == ' ') {
        ++at;
      }
      if (column->passed_over) {
        if (*at == '"') {
          return nullptr;
        }
        at += length_of_field(at, end);
      } else {
        const bool has_quotes = *at == '"';
        at += has_quotes ? 1 : 0;
        double value = 0.0;
        if (!parse_plain_decimal(at, value, dialect.delimiter) && !parse_number(at, end, value)) {
          return nullptr;
        }
        if (column->converts) {
          value = value * column->scale + column->offset;
        }
        if (!(value >= column->minimum) || !(value <= column->maximum) ||
            (has_quotes && *at++ != '"')) {
          return nullptr;
        }
        values[column->id] = value;
      }
      if (column == last) {
        break;
      }
      if (*at++ != dialect.delimiter) {
        return nullptr;
      }
    }
    at += *at == '\r' ? 1 : 0;
    return *at == '\n' && values[kTime] > last_time_s ? at : nullptr;
  }

  /// Any row, by the book; throws InputError if there is something wrong with it.
  void by_the_book(const TextPlace& line, double last_time_s, Values& values) const;

 private:
  struct Column {
    ProfileColumnId id;
    bool passed_over;
    bool converts;
    double scale;
    double offset;
    double minimum;
    double maximum;
  };

  /// Up to what may end a field that is passed over, or no text holds.
  std::size_t length_of_field(const char* at, const char* end) const {
    const std::array<char, 4> ends{layout_.dialect.delimiter, '\n', '\r', '\0'};
    return static_cast<std::size_t>(std::find_first_of(at, end, ends.begin(), ends.end()) - at);
  }

  ProfileLayout layout_;
  std::vector<Column> columns_;
};

/// Goes through the rows of a profile of any length in constant memory. All functions throw
/// InputError for what is no profile; after an error the object is of no further use.
class ProfileRows {
 public:
  /// See read_profile_header().
  ProfileRows(std::unique_ptr<ByteSource> source, std::string_view name, std::string_view accepted,
              const ProfileHeaderParser& layout_of);

  const ProfileLayout& layout() const noexcept { return parser_.layout(); }

  /// Goes to the next row; false at the end.
  bool next();

  const ProfileRowParser::Values& values() const noexcept { return values_; }

  const LineBuffer& lines() const noexcept { return lines_; }

 private:
  TextPlace this_line() const { return {name_, lines_.line_number(), lines_.line()}; }

  std::string name_;
  LineBuffer lines_;
  ProfileRowParser parser_;
  ProfileRowParser::Values values_{};
  double last_time_s_ = -std::numeric_limits<double>::infinity();
};

}  // namespace hal::files
