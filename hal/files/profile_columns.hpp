#pragma once

#include <bitset>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hal/files/column_map.hpp"
#include "hal/files/csv.hpp"
#include "hal/files/input_error.hpp"

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

/// One of the fields of a row: scale * field + offset is the value of a column.
struct ProfileField {
  ProfileColumnId id = kProfileColumnCount;  ///< the count: passed over
  std::string name;                          ///< in the file
  double scale = 1;
  double offset = 0;

  [[nodiscard]] bool passed_over() const { return id == kProfileColumnCount; }
  [[nodiscard]] bool converts() const { return scale != 1 || offset != 0; }
};

/// A field that is passed over although its name is nearly that of a column that is not there.
struct NearlyColumn {
  ProfileColumnId id;  ///< that column
  std::string words;   ///< what is passed over, and how it can be taken
};

/// What a header says of the rows.
struct ProfileLayout {
  CsvDialect dialect;
  std::vector<ProfileField> fields;
  ProfileChannels channels;          ///< of all fields
  std::vector<NearlyColumn> nearly;  ///< in order of the fields
};

/// The layout of a header line, `time_s` in it. Throws InputError for columns that are unknown, of
/// another unit or there twice, or that a map names and the line lacks; `needed` says there which
/// columns a file must have.
ProfileLayout parse_profile_columns(const TextPlace& line, std::string_view needed,
                                    const ColumnOptions& options = {});

}  // namespace hal::files
