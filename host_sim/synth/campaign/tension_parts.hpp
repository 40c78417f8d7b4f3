#pragma once

#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "host_sim/synth/plan/plan.hpp"
#include "host_sim/synth/tension/part.hpp"

namespace host_sim::synth {

/// What a plan hides in its recordings, made and begun for one session; with `only`, the part of
/// that name alone.
std::vector<std::unique_ptr<TensionPart>> tension_parts(const SynthPlan& plan,
                                                        const Setting& setting, std::uint64_t seed,
                                                        std::string_view only = {});

}  // namespace host_sim::synth
