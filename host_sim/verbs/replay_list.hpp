#pragma once

#include <vector>

#include "host_sim/replay/list_profiles.hpp"
#include "host_sim/verbs/replay_arguments.hpp"

namespace host_sim {

/// The profiles of a table, each with its model where there is one. Tables that earlier runs left
/// beside them are not among them.
/// @throws InputError where no profile has a model, where that of `--model` cannot be used, where
/// an output would overwrite a profile, and as list_profiles() does
std::vector<ListedProfile> profiles_with_models(const ReplayArguments& arguments);

}  // namespace host_sim
