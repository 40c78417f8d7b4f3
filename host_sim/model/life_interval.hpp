#pragma once

#include <string>
#include <string_view>

#include "hal/files/toml_table.hpp"
#include "host_sim/model/model.hpp"

namespace host_sim {

/// Reads `[life.interval]`: how sure the fit of [life] is of its numbers. All are needed:
///   level            above 0, below 1
///   pivot_tension_N  above 0 up to 1e6
///   ipl_scale, ipl_exponent, weibull_shape, life_at_pivot
///                    [low, high], above 0 up to 1e300, with the number that they are of between
/// @param life the numbers of [life]
/// @throws InputError for anything unknown, missing, of the wrong type or out of range
Model::Life::Interval read_life_interval(const hal::files::TomlTable& table,
                                         const Model::Life& life);

/// Whether a file can hold an interval: all ends above 0 and finite, low ends below the numbers
/// of `life` and high ends above.
bool can_be_written(const Model::Life::Interval& interval, const Model::Life& life);

/// The lines of the table without its name, each with `prefix` before its key, in numbers that read
/// back exactly.
std::string life_interval_text(const Model::Life::Interval& interval, std::string_view prefix);

}  // namespace host_sim
