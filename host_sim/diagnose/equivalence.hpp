#pragma once

#include <string>
#include <vector>

#include "host_sim/diagnose/audit.hpp"

namespace host_sim::diagnose {

/// The experiment that tells two effects apart, as the catalogue has it from either side; a crossed
/// design where it names none.
std::string experiment_for(const effects::TensionEffect& one, const effects::TensionEffect& other);

/// The connected components of the visible effects, joined by pairs above Audit::kSameCosine.
std::vector<EquivalenceClass> classes_of(const std::vector<EffectAudit>& effects,
                                         const std::vector<PairAudit>& pairs);

}  // namespace host_sim::diagnose
