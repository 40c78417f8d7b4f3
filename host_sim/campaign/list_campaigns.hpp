#pragma once

#include <filesystem>
#include <vector>

namespace host_sim {

/// Whether `folder` is a campaign: a folder that holds a campaign.toml.
bool is_campaign(const std::filesystem::path& folder);

/// The campaigns directly below `folder`, sorted by name; none is no error.
/// @throws InputError where `folder` is not a folder that can be read
std::vector<std::filesystem::path> list_campaigns(const std::filesystem::path& folder);

}  // namespace host_sim
