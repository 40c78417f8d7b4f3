#pragma once

#include <filesystem>

namespace host_sim {

/// Whether a campaign has this file, be it one that can be read or not.
bool is_there(const std::filesystem::path& file);

}  // namespace host_sim
