#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hal/files/input_error.hpp"
#include "hal/files/input_file.hpp"
#include "hal/files/plain_decimal.hpp"
#include "hal/files/profile_columns.hpp"
#include "hal/files/text.hpp"

namespace hal::files {

/// Reads the columns of a header line; throws InputError for those that are not accepted.
using ProfileHeaderParser = std::function<std::vector<ProfileColumnId>(const TextPlace&)>;

/// Reads up to the first row and gives the columns. `name` stands for the file in errors,
/// `accepted` says in the error for an empty file what is accepted.
std::vector<ProfileColumnId> read_profile_header(LineBuffer& lines, std::string_view name,
                                                 std::string_view accepted,
                                                 const ProfileHeaderParser& columns_of);

/// Throws InputError for a line that is no text.
void refuse_nul(const TextPlace& line);

/// Reads single rows of a profile: all of its columns, finite, within the ranges of
/// profile_columns() and with strictly increasing time.
class ProfileRowParser {
 public:
  /// By ProfileColumnId, and a 0 behind them; 0 where the file lacks the column.
  using Values = std::array<double, kProfileColumnCount + 1>;

  explicit ProfileRowParser(std::vector<ProfileColumnId> columns);

  std::span<const ProfileColumnId> columns() const noexcept { return columns_; }

  /// The common row: numbers, quoted or not, all right, and later than `last_time_s`. Gives the end
  /// of its line, or nullptr for any other row.
  /// @pre lines up to `end`, and kPlainDecimalReach octets behind it, can be read
  const char* plain(const char* at, const char* end, double last_time_s, Values& values) const {
    const Column* const last = &ranges_.back();
    for (const Column* column = ranges_.data();; ++column) {
      const bool has_quotes = *at == '"';
      at += has_quotes ? 1 : 0;
      double value = 0.0;
      if (!parse_plain_decimal(at, value) && !parse_number(at, end, value)) {
        return nullptr;
      }
      if (!(value >= column->minimum) || !(value <= column->maximum) ||
          (has_quotes && *at++ != '"')) {
        return nullptr;
      }
      values[column->id] = value;
      if (column == last) {
        break;
      }
      if (*at++ != ',') {
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
    double minimum;
    double maximum;
  };

  std::vector<ProfileColumnId> columns_;
  std::vector<Column> ranges_;
};

/// Goes through the rows of a profile of any length in constant memory. All functions throw
/// InputError for what is no profile; after an error the object is of no further use.
class ProfileRows {
 public:
  /// See read_profile_header().
  ProfileRows(std::unique_ptr<ByteSource> source, std::string_view name, std::string_view accepted,
              const ProfileHeaderParser& columns_of);

  /// The columns, in the order of the file.
  std::span<const ProfileColumnId> columns() const noexcept { return parser_.columns(); }

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
