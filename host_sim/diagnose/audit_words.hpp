#pragma once

#include <string>

#include "host_sim/diagnose/audit.hpp"

namespace host_sim::diagnose {

/// Why an effect is invisible and what would show it, or how clearly it shows. Where a channel is
/// missing, `effect.words` holds what is missing.
std::string words_for(const EffectAudit& effect);

/// The whole audit: a sentence for each invisible effect and for each class of more than one.
std::string words_for(const Audit& audit);

}  // namespace host_sim::diagnose
