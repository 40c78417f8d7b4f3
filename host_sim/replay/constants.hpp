#pragma once

#include "host_sim/io/model.hpp"
#include "host_sim/reference/constants.hpp"
#include "host_sim/reference/equations.hpp"
#include "lifemodel/block/parameters.hpp"

namespace host_sim {

/// The parameters that the estimator reads, computed from the model.
/// @throws std::invalid_argument where the target cannot represent the model
lifemodel::Parameters parameters_of(const Model& model);

/// The same model for the double-precision reference.
reference::Constants reference_constants_of(const Model& model);

/// The drive of the model in SI units. Precondition: the model has one.
reference::Drive drive_of(const Model& model);

/// Degrees, as in files, to radians.
double radians(double angle_deg);

}  // namespace host_sim
