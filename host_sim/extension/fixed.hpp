#pragma once

#include <span>

#include "host_sim/model/model.hpp"
#include "lifemodel/extension/extension.hpp"

namespace host_sim {

/// Extensions in fixed point, as the target evaluates them. Those that no controller evaluates are
/// left out; acting_extensions() names them.
/// @throws InputError where the target cannot represent a value; `model_name` stands for the model
lifemodel::extension::Extension fixed_extension(const Model& model,
                                                std::span<const Extension> extensions,
                                                std::string_view model_name);

}  // namespace host_sim
