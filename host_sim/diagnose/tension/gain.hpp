#pragma once

#include "host_sim/diagnose/diagnosis.hpp"
#include "host_sim/diagnose/tension/shape_search.hpp"
#include "host_sim/reference/constants.hpp"

namespace host_sim::diagnose {

/// Step 6: the nominal model, refitted, and the extended one on sessions that neither saw.
/// @pre three sessions or more
Gain measure_gain(const Evidence& evidence, std::span<const Component> model,
                  const reference::Constants& constants);

}  // namespace host_sim::diagnose
