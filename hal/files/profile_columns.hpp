#pragma once

#include <bitset>
#include <span>
#include <string>
#include <string_view>
#include <vector>

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

/// The columns of a header line, `time_s` among them. Throws InputError for columns that are
/// unknown, of another unit or there twice; `needed` says there which columns a file must have.
std::vector<ProfileColumnId> parse_profile_columns(const TextPlace& line, std::string_view needed);

}  // namespace hal::files
