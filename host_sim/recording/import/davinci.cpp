#include "host_sim/recording/import/davinci.hpp"

#include <fmt/format.h>

#include <array>
#include <map>
#include <utility>

#include "host_sim/campaign/csv_table.hpp"
#include "host_sim/recording/recording_file.hpp"

namespace host_sim::recording {
namespace {

enum Column : unsigned {
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
  kColumnCount,
};

constexpr std::array<CsvColumn, kColumnCount> kColumns{{
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

unsigned index_in(const CsvTable& table, Column column) {
  const double value = table.number(column, {0, 999});
  const auto index = static_cast<unsigned>(value);
  if (value != index) {
    table.place(column).fail(fmt::format("{} is {}", kColumns[column].name, value),
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
  const auto add = [&](ProfileColumnId id, Column column, double factor) {
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
  CsvTable table(std::move(source), name, kColumns);
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
