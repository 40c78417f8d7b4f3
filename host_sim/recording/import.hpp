#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "hal/files/input_file.hpp"
#include "host_sim/recording/recording.hpp"

namespace host_sim::recording {

/// A campaign of recordings to be written.
struct RecordedCampaign {
  std::string campaign_toml;
  /// Written to a file each of the name of the session with `.csv`; `file` and `line` do not count.
  /// Names of sessions are letters, digits and underscores.
  std::vector<Recording> recordings;
  std::size_t passed_over = 0;  ///< rows without a value
};

/// Writes campaign.toml, sessions.csv and the recordings; none appears before all are written.
/// Creates the folder where there is none.
/// @throws OutputError, for a folder that has files too
void write_campaign(const RecordedCampaign& campaign, const std::filesystem::path& folder);

struct DavinciOptions {
  /// Turns torques into tensions, and angles into travel. What is given as a torque stays free of
  /// it: all ratios of tensions do.
  double pulley_radius_mm = 5;
};

/// Reads a measured cable transmission, O'Neill, Stephens and Kowalewski, IEEE Robotics and
/// Automation Letters 3(4):3027 (2018), resampled: one CSV file with the columns freq_idx,
/// torque_idx, t_s, drive_pos_rad, drive_vel_rad_s, drive_torque_Nm, jaw_torque_Nm and others.
///
/// Each pair of frequency and brake level becomes a session. The drive works against the brake
/// while its angle falls, so tendon velocity and motor angle are those of the drive with the other
/// sign; input tension is drive torque, output tension the negative jaw torque, over the radius of
/// the pulley. The drive's torque falls below zero where friction carries the load back.
/// @param name stands for the file in errors
/// @throws InputError
RecordedCampaign import_davinci(std::unique_ptr<hal::files::ByteSource> source,
                                std::string_view name, const DavinciOptions& options);

}  // namespace host_sim::recording
