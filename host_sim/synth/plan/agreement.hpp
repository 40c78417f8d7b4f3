#pragma once

#include <string_view>

#include "host_sim/io/toml_table.hpp"
#include "host_sim/synth/plan/plan.hpp"

namespace host_sim::synth {

/// Throw InputError where [recordings], or [lives], do not agree with themselves or the model;
/// `top` is the whole file.
void check_recordings(const TomlTable& top, const SynthPlan& plan);
void check_lives(const TomlTable& top, const SynthPlan& plan);

/// @throws InputError that says which table of the model is missing, and what needs it
[[noreturn]] void fail_for_model(const TomlTable& top, std::string_view table,
                                 std::string_view why);

}  // namespace host_sim::synth
