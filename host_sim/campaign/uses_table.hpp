#pragma once

#include <vector>

#include "host_sim/campaign/campaign.hpp"
#include "host_sim/campaign/load_model.hpp"
#include "host_sim/io/toml_table.hpp"

namespace host_sim {

/// The tables [[use]] at the top of campaign.toml.
/// @throws InputError
std::vector<Campaign::Use> uses_in(const TomlTable& top, const LoadModel& model);

}  // namespace host_sim
