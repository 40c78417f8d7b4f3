#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hal/files/input_file.hpp"
#include "hal/files/profile_columns.hpp"
#include "host_sim/recording/import.hpp"

namespace host_sim::recording {

/// A channel out of a column of a table: scale * column + offset, or scale times the rate of change
/// of the column.
struct ColumnMap {
  hal::files::ProfileColumnId channel = hal::files::kTime;
  std::string column;
  double scale = 1;
  double offset = 0;  ///< in the unit of the channel
  bool rate = false;  ///< per second, by central differences
};

/// Reads `CHANNEL=[-][FACTOR*]COLUMN[ in UNIT][+OFFSET]`, or `rate(COLUMN[ in UNIT])` in place of
/// the column, whose name stands in double quotes where it holds more than letters, digits and `_`.
/// @throws std::invalid_argument that says what is accepted
ColumnMap column_map(std::string_view text);

struct ColumnsOptions {
  std::vector<ColumnMap> maps;
  std::optional<double> rate_Hz;              ///< instead of a time
  std::optional<std::string> session_column;  ///< each of its values is a session
};

/// What lacks for a recording that can be diagnosed, empty where nothing does.
std::string missing_map(const ColumnsOptions& options);

/// Adds the sessions of a table: fields between commas, semicolons or tabs (as in its first line,
/// which has the names), `#` starts a comment line. Other columns are passed over.
/// @param name stands for the file in errors
/// @param session its name, where no column says it
/// @pre nothing is missing in the options
/// @throws InputError
void import_columns(std::unique_ptr<hal::files::ByteSource> source, std::string_view name,
                    std::string_view session, const ColumnsOptions& options,
                    RecordedCampaign& campaign);

/// campaign.toml of a campaign whose drive and sheath are not known: to be filled in.
/// @param two_sided whether the drive works in both directions
std::string unknown_campaign(std::string_view name, bool two_sided);

}  // namespace host_sim::recording
