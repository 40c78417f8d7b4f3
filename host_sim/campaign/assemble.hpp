#pragma once

#include <vector>

#include "host_sim/campaign/blocks_file.hpp"
#include "host_sim/campaign/campaign.hpp"
#include "host_sim/campaign/campaign_file.hpp"
#include "host_sim/campaign/specimens_file.hpp"

namespace host_sim {

/// A campaign of the contents of its files, with specimens in order of their names; no `blocks`
/// where there is no such file.
/// @throws InputError where the files do not agree, or where the model lacks what a load needs
Campaign assemble(CampaignFile file, std::vector<SpecimenRow> specimens,
                  const std::vector<BlockRow>& blocks);

}  // namespace host_sim
