#pragma once

#include "host_sim/io/toml_table.hpp"
#include "host_sim/synth/plan/plan.hpp"

namespace host_sim::synth {

/// The tables of a plan, each read from the table given. All throw InputError.
RecordingPlan recordings_in(const TomlTable& table);
Noise noise_in(const TomlTable& table);
ScatterPlan scatter_in(const TomlTable& table);
Thermal thermal_in(const TomlTable& table);
LifePlan lives_in(const TomlTable& table);

/// The departures of [effects], or of [outside].
std::vector<Hidden> hidden_in(const TomlTable& table, bool outside);

/// Throws InputError where the parts of a plan do not agree; `top` is the whole file.
void check_agreement(const TomlTable& top, const SynthPlan& plan);

}  // namespace host_sim::synth
