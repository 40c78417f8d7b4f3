#include "host_sim/recording/import/campaign_folder.hpp"

#include <fmt/format.h>

#include <iterator>
#include <string_view>
#include <system_error>

#include "host_sim/io/interruption.hpp"
#include "host_sim/io/output_file.hpp"

namespace host_sim::recording {
namespace {

namespace fs = std::filesystem;

std::string in_csv_quotes(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    quoted += c;
    if (c == '"') {
      quoted += c;
    }
  }
  return quoted + '"';
}

std::string sessions_text(const std::vector<Recording>& recordings) {
  std::string text = "session,specimen,file,start_cycle\n";
  for (const Recording& recording : recordings) {
    fmt::format_to(std::back_inserter(text), "{0},{1},{0}.csv,{2}\n", recording.session,
                   in_csv_quotes(recording.specimen), recording.start_cycle);
  }
  return text;
}

std::string recording_text(const Recording& recording) {
  std::string text;
  const auto add_row = [&](const auto& cell_of) {
    const char* comma = "";
    for (std::size_t id = 0; id < kProfileColumnCount; ++id) {
      if (!recording.channels[id].empty()) {
        fmt::format_to(std::back_inserter(text), "{}{}", comma, cell_of(id));
        comma = ",";
      }
    }
    text += '\n';
  };
  add_row([](std::size_t id) { return profile_columns()[id].name; });
  for (std::size_t i = 0; i < recording.samples(); ++i) {
    add_row([&](std::size_t id) { return recording.channels[id][i]; });
  }
  return text;
}

void prepare(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) {
    throw OutputError(folder.string(), error.message());
  }
  if (!fs::is_empty(folder, error) || error) {
    throw OutputError(folder.string(), error ? error.message() : "the folder is not empty");
  }
}

}  // namespace

void write_campaign(const RecordedCampaign& campaign, const fs::path& folder) {
  prepare(folder);
  std::vector<OutputFile> files;
  const auto write = [&](const std::string& name, const std::string& text) {
    files.emplace_back(folder / name).write(text);
  };
  for (const Recording& recording : campaign.recordings) {
    stop_if_interrupted();
    write(recording.session + ".csv", recording_text(recording));
  }
  write("sessions.csv", sessions_text(campaign.recordings));
  write("campaign.toml", campaign.campaign_toml);
  for (OutputFile& file : files) {
    file.commit();
  }
}

}  // namespace host_sim::recording
