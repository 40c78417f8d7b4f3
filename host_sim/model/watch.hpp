#pragma once

#include <string>
#include <string_view>

#include "hal/files/toml_table.hpp"
#include "host_sim/model/model.hpp"

namespace host_sim {

/// Reads `[watch]`: what a controller watches beside the damage. Each key may be left out or 0,
/// which is off; but for the horizon, 8 hours where it is left out:
///   minimum_tension_N  0..1e6, needed by slack_travel_mm
///   broken_tension_N   0..1e6, and with it broken_travel_mm 0..1e6
///   slack_travel_mm    0..1e6
///   horizon_h          0.001..87600
///   advice_risk        0..0.99, and with it advice_until_h 0..1e6
/// @throws InputError for anything unknown, of the wrong type or out of range, and for a travel or
/// an advice that lacks the key that it needs
Model::Watch read_watch(const hal::files::TomlTable& table);

/// Throws InputError where a tension is not below the ultimate one.
void check_watch(const hal::files::TomlTable& table, const Model::Watch& watch,
                 const Model::Cable& cable);

/// The lines of the table without its name, each with `prefix` before its key, in numbers that read
/// back exactly.
std::string watch_text(const Model::Watch& watch, std::string_view prefix);

}  // namespace host_sim
