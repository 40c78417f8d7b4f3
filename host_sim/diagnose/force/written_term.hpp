#pragma once

#include <optional>
#include <span>

#include "host_sim/diagnose/force/force_model.hpp"
#include "host_sim/model/model.hpp"

namespace host_sim::diagnose {

/// The table [extension.<id>] that stands for a term of the forward model; nothing of what a model
/// cannot hold: slack and compliance. Harmonics of the stroke about its middle become those of its
/// length about position 0.
/// @param values of parameters_of(term, scales)
std::optional<Extension> written_term(ForceTerm term, std::span<const double> values,
                                      const ForceScales& scales);

/// The coefficient of friction of a model with these extensions: with `friction_load` it is that at
/// 50 N, in the forward model that at the scale of force.
double written_friction(double friction, std::span<const Extension> extensions,
                        const ForceScales& scales);

}  // namespace host_sim::diagnose
