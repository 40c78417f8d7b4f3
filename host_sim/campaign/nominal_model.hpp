#pragma once

#include <string>
#include <string_view>

#include "host_sim/campaign/campaign.hpp"

namespace host_sim {

/// Checks, before the long work, that the campaign's nominal model has what a model needs besides
/// its [life].
/// @throws InputError naming campaign.toml and what to add to it
void require_nominal_model(const Campaign& campaign);

/// Checks that it has its [life] too. The same.
void require_nominal_life(const Campaign& campaign);

/// The tables of `model.toml` in the order of the file format, without its head and schema, in
/// numbers that read back exactly. `how` says where the numbers come from: "fitted".
/// @throws InputError naming campaign.toml where a number is one that no model can hold
std::string model_tables(const Campaign& campaign, Model model, std::string_view how);

}  // namespace host_sim
