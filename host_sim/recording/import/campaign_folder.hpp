#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "host_sim/recording/recording.hpp"

namespace host_sim::recording {

/// A campaign of recordings to be written.
struct RecordedCampaign {
  std::string campaign_toml;
  /// Written to a file each of the name of the session with `.csv`; `file` and `line` do not count.
  /// Names of sessions are letters, digits and underscores.
  std::vector<Recording> recordings;
};

/// Writes campaign.toml, sessions.csv and the recordings; none appears before all are written.
/// Creates the folder where there is none.
/// @throws OutputError, for a folder that has files too
void write_campaign(const RecordedCampaign& campaign, const std::filesystem::path& folder);

}  // namespace host_sim::recording
