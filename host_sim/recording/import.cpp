#include "host_sim/recording/import.hpp"

#include <fmt/format.h>

#include <array>
#include <iterator>
#include <map>
#include <string_view>
#include <system_error>
#include <utility>

#include "hal/files/interruption.hpp"
#include "hal/files/output_file.hpp"
#include "host_sim/campaign/csv_table.hpp"
#include "host_sim/recording/recording_files.hpp"

namespace host_sim::recording {

using hal::files::ByteSource;
using hal::files::InputError;
using enum hal::files::ProfileColumnId;
using hal::files::NumberRange;
using hal::files::OutputError;
using hal::files::OutputFile;
using hal::files::profile_columns;
using hal::files::ProfileColumnId;
using hal::files::stop_if_interrupted;

namespace {

/// What no log of a drive knows and a model file has to.
constexpr std::string_view kWire = R"(
# The model that `host_sim diagnose --out` writes is of a wire, too: add [model.cable], [model.counting]
# and [model.life] with the keys that a model file has in [cable], [counting] and [life].
)";

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
  write("campaign.toml", campaign.campaign_toml + std::string(kWire));
  for (OutputFile& file : files) {
    file.commit();
  }
}

namespace {

enum DavinciColumn : unsigned {
  kFrequency,
  kLoad,
  kTimeColumn,
  kDriveAngle,
  kDriveVelocity,
  kDriveTorque,
  kDriveCurrent,
  kJawAngle,
  kJawVelocity,
  kJawTorque,
  kBrakeCurrent,
  kTrajectory,
  kDavinciColumnCount,
};

constexpr std::array<CsvColumn, kDavinciColumnCount> kDavinciColumns{{
    {.name = "freq_idx", .required = true},
    {.name = "torque_idx", .required = true},
    {.name = "t_s", .unit = "s", .required = true},
    {.name = "drive_pos_rad", .unit = "rad", .required = true},
    {.name = "drive_vel_rad_s", .unit = "rad_s", .required = true},
    {.name = "drive_torque_Nm", .unit = "Nm", .required = true},
    {.name = "drive_current_A", .unit = "A"},
    {.name = "jaw_pos_rad", .unit = "rad"},
    {.name = "jaw_vel_rad_s", .unit = "rad_s"},
    {.name = "jaw_torque_Nm", .unit = "Nm", .required = true},
    {.name = "brake_cmd_A", .unit = "A"},
    {.name = "traj_counts"},
}};

constexpr NumberRange kAnything{-1e6, 1e6};

constexpr std::string_view kCampaign = R"([campaign]
name = "da Vinci cable transmission"

# Measured are torques: of the drive, and of the jaw behind the cable. Divided by the radius of a
# pulley of {0} mm they stand for input and output tension in N; the ratios of tensions, and so
# friction, do not depend on the radius. Nothing is known of the order of the sessions: each
# begins at cycle 0.

[model.sheath]
# Only the product counts: exp(2 mu phi) is 1.9 between pulling and letting go.
friction_coefficient = 0.102
bend_angle_deg = 180.0

[model.drive]
# The radius turns the angle of the drive into travel. No current was taken over: the torque
# constant stands for nothing.
torque_constant_Nm_per_A = 1.0
gear_ratio = 1.0
gear_efficiency = 1.0
spool_radius_mm = {0}
current_offset_A = 0.0
)";

unsigned index_in(const CsvTable& table, DavinciColumn column) {
  const double value = table.number(column, {0, 999});
  const auto index = static_cast<unsigned>(value);
  if (value != index) {
    table.place(column).fail(fmt::format("{} is {}", kDavinciColumns[column].name, value),
                             "a whole number");
  }
  return index;
}

void add_sample(const CsvTable& table, double radius_m, Channels& channels) {
  const double time_s = table.number(kTimeColumn, kAnything);
  if (!channels[kTime].empty() && !(time_s > channels[kTime].back())) {
    table.place(kTimeColumn)
        .fail(fmt::format("time goes from {} s to {} s", channels[kTime].back(), time_s),
              "time that increases within each pair of freq_idx and torque_idx");
  }
  channels[kTime].push_back(time_s);
  const auto add = [&](ProfileColumnId id, DavinciColumn column, double factor) {
    channels[id].push_back(factor * table.number(column, kAnything));
  };
  add(kInputTensionColumn, kDriveTorque, 1 / radius_m);
  add(kOutputTensionColumn, kJawTorque, -1 / radius_m);
  add(kTendonVelocity, kDriveVelocity, -radius_m);
  add(kMotorAngle, kDriveAngle, -1);
}

}  // namespace

RecordedCampaign import_davinci(std::unique_ptr<ByteSource> source, std::string_view name,
                                const DavinciOptions& options) {
  CsvTable table(std::move(source), name, kDavinciColumns);
  std::map<std::pair<unsigned, unsigned>, Channels> sessions;
  while (table.next()) {
    const auto key = std::pair(index_in(table, kFrequency), index_in(table, kLoad));
    add_sample(table, options.pulley_radius_mm / 1000, sessions[key]);
  }
  RecordedCampaign campaign;
  campaign.campaign_toml = fmt::format(kCampaign, options.pulley_radius_mm);
  for (auto& [key, channels] : sessions) {
    Recording& recording = campaign.recordings.emplace_back();
    recording.session = fmt::format("frequency{}_load{:02}", key.first, key.second);
    recording.specimen = "cable";
    recording.channels = std::move(channels);
    if (recording.samples() < kFewestSamples) {
      throw InputError(name, 0, 0,
                       fmt::format("{} samples of freq_idx {} and torque_idx {}",
                                   recording.samples(), key.first, key.second),
                       fmt::format("at least {}", kFewestSamples));
    }
  }
  return campaign;
}

}  // namespace host_sim::recording
