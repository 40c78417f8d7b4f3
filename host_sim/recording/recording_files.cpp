#include "host_sim/recording/recording_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <set>
#include <system_error>
#include <unordered_map>
#include <utility>

#include "hal/files/input_error.hpp"
#include "hal/files/interruption.hpp"
#include "hal/files/profile_rows.hpp"
#include "hal/files/text.hpp"
#include "host_sim/campaign/campaign.hpp"
#include "host_sim/campaign/campaign_files.hpp"
#include "host_sim/campaign/csv_table.hpp"
#include "host_sim/io/compressed.hpp"
#include "host_sim/recording/recording.hpp"

namespace host_sim::recording {

using hal::files::ByteSource;
using hal::files::ColumnOptions;
using hal::files::in_quotes;
using hal::files::InputError;
using enum hal::files::ProfileColumnId;
using hal::files::parse_profile_columns;
using hal::files::profile_columns;
using hal::files::ProfileColumnId;
using hal::files::ProfileLayout;
using hal::files::ProfileRows;
using hal::files::stop_if_interrupted;
using hal::files::TextPlace;

namespace {

enum SessionColumn : unsigned { kSession, kSpecimen, kFile, kStartCycle, kSessionColumnCount };

constexpr std::array<CsvColumn, kSessionColumnCount> kSessionColumns{{
    {.name = "session", .required = true},
    {.name = "specimen", .required = true},
    {.name = "file", .required = true},
    {.name = "start_cycle", .required = true},
}};

bool leaves_the_folder(const std::filesystem::path& file) {
  if (file.is_absolute()) {
    return true;
  }
  const std::filesystem::path normal = file.lexically_normal();
  return *normal.begin() == "..";
}

std::string file_in_row(const CsvTable& table) {
  const std::string& file = table.text(kFile);
  if (file.empty()) {
    table.place(kFile).fail("file is empty", "the path of a recording in the campaign folder");
  }
  if (leaves_the_folder(file)) {
    table.place(kFile).fail(fmt::format("file {} leaves the campaign folder", in_quotes(file)),
                            "a path within the campaign folder");
  }
  return file;
}

SessionRow session_in(const CsvTable& table) {
  SessionRow row;
  row.session = name_in_row(table, kSession);
  row.specimen = name_in_row(table, kSpecimen);
  row.file = file_in_row(table);
  row.start_cycle = table.number(kStartCycle, {0.0, 1e18});
  row.specimen_place = table.place(kSpecimen);
  row.file_place = table.place(kFile);
  return row;
}

}  // namespace

std::vector<SessionRow> parse_sessions(std::unique_ptr<ByteSource> source, std::string_view name) {
  CsvTable table(std::move(source), name, kSessionColumns);
  std::vector<SessionRow> rows;
  std::unordered_map<std::string, std::uint64_t> lines;
  while (table.next()) {
    SessionRow row = session_in(table);
    const auto [first, is_new] = lines.try_emplace(row.session, table.line());
    if (!is_new) {
      table.place(kSession).fail(fmt::format("session {} a second time, first in line {}",
                                             in_quotes(row.session), first->second),
                                 "one row for each session");
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

namespace {

constexpr std::string_view kNeeded =
    "time_s, output_tension_N, tendon_velocity_m_s, and input_tension_N or motor_current_A or both";

ProfileLayout layout_of(const TextPlace& line, const ColumnOptions& options) {
  ProfileLayout layout = parse_profile_columns(line, kNeeded, options);
  const auto fail = [&](std::string_view missing) {
    line.fail(line.text.size(), fmt::format("no column {}", missing), kNeeded);
  };
  if (!layout.channels[kInputTensionColumn] && !layout.channels[kMotorCurrentColumn]) {
    fail("input_tension_N or motor_current_A");
  }
  for (const ProfileColumnId id : {kOutputTensionColumn, kTendonVelocity}) {
    if (!layout.channels[id]) {
      fail(profile_columns()[id].name);
    }
  }
  return layout;
}

}  // namespace

RecordingText parse_recording(std::unique_ptr<ByteSource> source, std::string_view name,
                              const ColumnOptions& columns) {
  constexpr std::size_t kSamplesBetweenStops = 1 << 16;
  ProfileRows rows(std::move(source), name, fmt::format("a CSV file with {}", kNeeded),
                   [&](const TextPlace& line) { return layout_of(line, columns); });
  RecordingText text{.channels = {}, .nearly = rows.layout().nearly};
  Channels& channels = text.channels;
  while (rows.next()) {
    for (unsigned id = 0; id < kProfileColumnCount; ++id) {
      if (rows.layout().channels[id]) {
        channels[id].push_back(rows.values()[id]);
      }
    }
    if (channels[kTime].size() % kSamplesBetweenStops == 0) {
      stop_if_interrupted();
    }
  }
  const std::size_t samples = channels[kTime].size();
  if (samples < kFewestSamples) {
    throw InputError(name, rows.lines().line_number(), 0,
                     fmt::format("the file ends after {} samples", samples),
                     fmt::format("at least {} samples", kFewestSamples));
  }
  return text;
}

namespace {

namespace fs = std::filesystem;

std::vector<SessionRow> read_sessions(const fs::path& path) {
  if (!is_there(path)) {
    return {};
  }
  return parse_sessions(open_input(path, "sessions.csv that can be read, or none"), path.string());
}

void check_specimens(const std::vector<SessionRow>& rows, const fs::path& path) {
  if (!is_there(path)) {
    return;
  }
  std::set<std::string> names;
  for (const SpecimenRow& row : parse_specimens(
           open_input(path, "specimens.csv that can be read, or none"), path.string())) {
    names.insert(row.specimen.name);
  }
  for (const SessionRow& row : rows) {
    if (!names.contains(row.specimen)) {
      row.specimen_place.fail(
          fmt::format("a session of {}, which is no specimen", in_quotes(row.specimen)),
          "specimens of specimens.csv");
    }
  }
}

/// Finds the recordings of a campaign, each once and within its folder.
class RecordingFiles {
 public:
  explicit RecordingFiles(const fs::path& folder)
      : folder_(folder.empty() ? fs::path(".") : folder), root_(fs::canonical(folder_)) {}

  /// @throws InputError
  fs::path file_of(const SessionRow& row) {
    fs::path file = folder_ / row.file;
    std::error_code error;
    const fs::path real = fs::canonical(file, error);
    if (error) {
      fail(row, "cannot be opened: " + error.message(), "the path of a recording");
    }
    if (*real.lexically_relative(root_).begin() == "..") {
      fail(row, "leaves the campaign folder through a link", "a file within the campaign folder");
    }
    if (!fs::is_regular_file(real, error)) {
      fail(row, "is not a file", "the path of a recording");
    }
    const auto [first, is_new] = lines_.try_emplace(real, row.file_place.line);
    if (!is_new) {
      fail(row, fmt::format("a second time, first in line {}", first->second),
           "one recording for each session");
    }
    return file;
  }

 private:
  [[noreturn]] static void fail(const SessionRow& row, const std::string& what,
                                std::string_view accepted) {
    row.file_place.fail(fmt::format("file {} {}", in_quotes(row.file), what), accepted);
  }

  fs::path folder_, root_;
  std::map<fs::path, std::uint64_t> lines_;
};

}  // namespace

std::vector<Recording> read_recordings(const fs::path& campaign_folder,
                                       const ColumnOptions& columns) {
  const std::vector<SessionRow> rows = read_sessions(campaign_folder / "sessions.csv");
  if (rows.empty()) {
    return {};
  }
  check_specimens(rows, campaign_folder / "specimens.csv");
  RecordingFiles files(campaign_folder);
  std::vector<Recording> recordings;
  for (const SessionRow& row : rows) {
    Recording& recording = recordings.emplace_back();
    recording.session = row.session;
    recording.specimen = row.specimen;
    recording.file = files.file_of(row);
    recording.start_cycle = row.start_cycle;
    recording.line = row.file_place.line;
    RecordingText text = parse_recording(open_input(recording.file, "a recording that can be read"),
                                         recording.file.string(), columns);
    recording.channels = std::move(text.channels);
    recording.nearly = std::move(text.nearly);
  }
  std::sort(recordings.begin(), recordings.end(),
            [](const Recording& a, const Recording& b) { return a.session < b.session; });
  return recordings;
}

std::vector<fs::path> files_of_campaign(const fs::path& campaign_folder) {
  std::vector<fs::path> files;
  for (const char* const name : {"campaign.toml", "specimens.csv", "blocks.csv", "sessions.csv"}) {
    files.push_back(campaign_folder / name);
  }
  std::error_code error;
  if (!fs::is_regular_file(files.back(), error)) {
    return files;
  }
  try {
    for (const SessionRow& row : read_sessions(fs::path(files.back()))) {
      files.push_back(campaign_folder / row.file);
    }
  } catch (const InputError&) {  // whoever reads the campaign reports it
  }
  return files;
}

}  // namespace host_sim::recording
