#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <system_error>
#include <utility>

#include "host_sim/campaign/is_there.hpp"
#include "host_sim/campaign/specimens_file.hpp"
#include "host_sim/io/printable.hpp"
#include "host_sim/recording/recording.hpp"
#include "host_sim/recording/recording_file.hpp"
#include "host_sim/recording/sessions_file.hpp"

namespace host_sim::recording {
namespace {

namespace fs = std::filesystem;

std::vector<SessionRow> read_sessions(const fs::path& path) {
  if (!is_there(path)) {
    return {};
  }
  return parse_sessions(open_source(path, "sessions.csv that can be read, or none"), path.string());
}

void check_specimens(const std::vector<SessionRow>& rows, const fs::path& path) {
  if (!is_there(path)) {
    return;
  }
  std::set<std::string> names;
  for (const SpecimenRow& row : parse_specimens(
           open_source(path, "specimens.csv that can be read, or none"), path.string())) {
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

std::vector<Recording> read_recordings(const fs::path& campaign_folder) {
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
    recording.channels = parse_recording(
        open_source(recording.file, "a recording that can be read"), recording.file.string());
  }
  std::sort(recordings.begin(), recordings.end(),
            [](const Recording& a, const Recording& b) { return a.session < b.session; });
  return recordings;
}

}  // namespace host_sim::recording
