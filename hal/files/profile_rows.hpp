#pragma once

#include <array>
#include <bitset>
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

namespace hal::files {

/// A column that a profile may hold, with the range of its values.
struct ProfileColumn {
  std::string_view name;
  std::string_view unit;  ///< the suffix of `name`
  double minimum;
  double maximum;
};

/// The places of the columns in profile_columns().
enum ProfileColumnId : unsigned {
  kTime,
  kInputTensionColumn,
  kMotorCurrentColumn,
  kOutputTensionColumn,
  kTendonVelocity,
  kBendAngle,
  kMotorAngle,
  kSheathTemperature,
  kWindingTemperature,
  kProfileColumnCount,
};

/// Columns that are there, by ProfileColumnId.
using ProfileChannels = std::bitset<kProfileColumnCount>;

/// All columns that are known; each is checked in every row, whether it is needed or not.
std::span<const ProfileColumn, kProfileColumnCount> profile_columns();

/// The names of all columns, separated by commas.
std::string profile_column_names();

/// The columns of a header line, `time_s` among them. Throws InputError for columns that are
/// unknown, of another unit or there twice; `needed` says there which columns a file must have.
std::vector<ProfileColumnId> parse_profile_columns(const TextPlace& line, std::string_view needed);

/// Goes through the rows of a profile of any length in constant memory: all of its columns, finite,
/// within the ranges of profile_columns() and with strictly increasing time. All functions throw
/// InputError for anything else; after an error the object is of no further use.
class ProfileRows {
 public:
  /// Reads the columns of a header line; throws InputError for those that are not accepted.
  using HeaderParser = std::function<std::vector<ProfileColumnId>(const TextPlace&)>;

  /// Reads up to the first row. `name` stands for the file in errors, `accepted` says in the error
  /// for an empty file what is accepted.
  ProfileRows(std::unique_ptr<ByteSource> source, std::string_view name, std::string_view accepted,
              const HeaderParser& columns_of);

  /// The columns, in the order of the file.
  std::span<const ProfileColumnId> columns() const noexcept { return columns_; }

  /// Goes to the next row; false at the end.
  bool next();

  /// The values of this row by ProfileColumnId, and a 0 behind them; 0 where the file lacks it.
  const std::array<double, kProfileColumnCount + 1>& values() const noexcept { return values_; }

  const LineBuffer& lines() const noexcept { return lines_; }

 private:
  TextPlace this_line() const { return {name_, lines_.line_number(), lines_.line()}; }
  void skip_comment();
  void go_to_content(std::string_view accepted, std::string_view nothing);
  bool read_plain_row();
  void read_row();

  std::string name_;
  LineBuffer lines_;
  std::vector<ProfileColumnId> columns_;
  std::array<double, kProfileColumnCount + 1> values_{};
  double last_time_s_ = -std::numeric_limits<double>::infinity();
};

}  // namespace hal::files
