#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host_sim/campaign/campaign.hpp"
#include "host_sim/campaign/place.hpp"

namespace host_sim {

/// What campaign.toml holds.
struct CampaignFile {
  std::string name;
  Campaign::Nominal nominal;
  Place model;  ///< of [model]; the file where there is none
  std::vector<Campaign::Use> uses;
};

/// Reads and checks campaign.toml; `file` stands for it in errors.
/// @throws InputError
CampaignFile parse_campaign_file(std::string_view text, std::string_view file);

}  // namespace host_sim
