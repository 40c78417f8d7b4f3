#pragma once

#include <string>

#include "host_sim/synth/plan/plan.hpp"

namespace host_sim::synth {

/// campaign.toml: the name and the nominal model, nothing of what is hidden.
std::string campaign_text(const SynthPlan& plan);

}  // namespace host_sim::synth
