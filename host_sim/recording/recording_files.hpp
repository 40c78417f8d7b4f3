#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "hal/files/column_map.hpp"
#include "hal/files/input_file.hpp"
#include "hal/files/profile_columns.hpp"
#include "host_sim/campaign/csv_table.hpp"
#include "host_sim/recording/recording.hpp"

namespace host_sim::recording {

/// A row of sessions.csv.
struct SessionRow {
  std::string session;
  std::string specimen;
  std::string file;        ///< relative to the folder, within it as far as its text shows
  double start_cycle = 0;  ///< at least 0
  FilePosition specimen_place, file_place;
};

/// Reads and checks sessions.csv; `name` stands for the file in errors.
/// @throws InputError, for the second row of a session too
std::vector<SessionRow> parse_sessions(std::unique_ptr<hal::files::ByteSource> source,
                                       std::string_view name);

/// The fewest samples of a recording.
inline constexpr std::size_t kFewestSamples = 16;

/// The samples of one recording, and what its header leaves in doubt.
struct RecordingText {
  Channels channels;
  std::vector<hal::files::NearlyColumn> nearly;
};

/// Reads and checks one recording; `name` stands for the file in errors.
/// @throws InputError
RecordingText parse_recording(std::unique_ptr<hal::files::ByteSource> source, std::string_view name,
                              const hal::files::ColumnOptions& columns = {});

}  // namespace host_sim::recording
