#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hal::files {

enum ProfileColumnId : unsigned;

/// A column of a profile out of one of a file that others wrote: scale * column + offset, or scale
/// times the rate of change of the column.
struct ColumnMap {
  ProfileColumnId channel{};
  std::string column;
  double scale = 1;
  double offset = 0;  ///< in the unit of the channel
  bool rate = false;  ///< per second

  [[nodiscard]] double of(double value) const { return scale * value + offset; }
};

/// Reads `[-][FACTOR*]COLUMN[ in UNIT][+OFFSET]=CHANNEL`, or `rate(COLUMN[ in UNIT])` in place of
/// the column, whose name stands in double quotes where it could be read as anything else.
/// @throws std::invalid_argument that says what is accepted
ColumnMap column_map(std::string_view text);

/// How the columns of a file are to be taken.
struct ColumnOptions {
  std::vector<ColumnMap> maps;  ///< each channel once, each column once; no rates
  bool ignore_extra = false;    ///< columns that are not known are passed over
  /// Whoever reads can give `--column` and `--ignore-extra`, so that errors may name them.
  bool given_by_options = false;
};

/// The map that takes a column whose name ends with another unit than that of the channel, as
/// column_map() reads it; none where the unit is not known. @param unit the end of `column`
std::optional<std::string> map_of_unit(std::string_view column, std::string_view unit,
                                       ProfileColumnId channel);

/// The name of a column as column_map() reads it.
std::string column_word(std::string_view column);

}  // namespace hal::files
