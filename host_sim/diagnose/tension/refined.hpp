#pragma once

#include <vector>

#include "host_sim/diagnose/tension/shape_search.hpp"

namespace host_sim::diagnose {

/// Signatures are in terms of the friction that is there, which that of the evidence's baseline is
/// only near to, and some in terms of their own size. Takes both from the model's fit, and looks
/// anew, and closer, for the shapes of what acts at reversals, which change with them. In turns,
/// until all hardly change.
std::vector<Component> refined(Evidence& evidence, std::vector<Component> model);

/// Takes the friction of the model's fit alone: its shapes stay, and its sizes go with the
/// friction.
void take_friction_of(Evidence& evidence, std::vector<Component> model);

}  // namespace host_sim::diagnose
