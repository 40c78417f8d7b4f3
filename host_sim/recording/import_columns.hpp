#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hal/files/column_map.hpp"
#include "hal/files/input_file.hpp"
#include "host_sim/recording/import.hpp"

namespace host_sim::recording {

struct ColumnsOptions {
  /// How channels are made of columns; a channel whose own name a column has needs none.
  std::vector<hal::files::ColumnMap> maps;
  std::optional<double> rate_Hz;              ///< instead of a time
  std::optional<std::string> session_column;  ///< each of its values is a session
  /// What the output carries throughout, where nothing measured it.
  std::optional<double> dead_load_N;
  bool ignore_missing = false;  ///< rows are passed over that lack a value which is taken
};

/// What does not go together, empty where all does.
std::string conflict_of(const ColumnsOptions& options);

/// Adds the sessions of a table: CSV in any dialect, the first line with the names, `#` starts a
/// comment line. Other columns are passed over.
/// @param name stands for the file in errors
/// @param session its name, where no column says it
/// @pre nothing is in conflict in the options
/// @throws InputError, also where a channel lacks that a recording needs
void import_columns(std::unique_ptr<hal::files::ByteSource> source, std::string_view name,
                    std::string_view session, const ColumnsOptions& options,
                    RecordedCampaign& campaign);

/// campaign.toml of a campaign whose drive and sheath are not known: to be filled in.
/// @param two_sided whether the drive works in both directions
std::string unknown_campaign(std::string_view name, bool two_sided);

}  // namespace host_sim::recording
