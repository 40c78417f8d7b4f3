#pragma once

#include <string_view>

#include "host_sim/model/model.hpp"
#include "host_sim/reference/constants.hpp"
#include "host_sim/reference/equations.hpp"
#include "lifemodel/extension/extended_block.hpp"

namespace host_sim {

/// The parameters that the estimator reads, computed from the model.
/// @param model_name stands for the model in errors
/// @throws InputError where the target cannot represent the model
lifemodel::Parameters parameters_of(const Model& model, std::string_view model_name);

/// The same with the extensions that a controller evaluates.
/// @throws InputError where the target cannot represent the model
lifemodel::ExtendedParameters extended_parameters_of(const Model& model,
                                                     std::string_view model_name);

/// The same model for the double-precision reference.
reference::Constants reference_constants_of(const Model& model);

/// Degrees, as in files, to radians.
double radians(double angle_deg);

}  // namespace host_sim
