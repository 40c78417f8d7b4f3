#pragma once

#include <ostream>
#include <string>

#include "host_sim/diagnose/plan/foresee.hpp"

namespace host_sim::diagnose {

/// {"sessions", "samples", "effects": [{"id", "visible", "share_left", "standard_deviations",
/// "words"}], "equivalent_sets": [[id, ...]], "invisible": [id], "next_experiment"}
std::string foresight_json(const Foresight& foresight);

/// The same for people: a line for each effect, the clearest first.
void write_foresight(std::ostream& out, const Foresight& foresight);

}  // namespace host_sim::diagnose
