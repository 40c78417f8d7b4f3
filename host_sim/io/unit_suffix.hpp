#pragma once

#include <optional>
#include <string_view>

namespace host_sim {

/// If `name` differs from `known` by its unit suffix alone, that suffix (empty if it has none),
/// e.g. `kN` for `input_tension_kN` against `input_tension_N` with the unit `N`. A known name
/// without a unit has the empty `unit`.
std::optional<std::string_view> other_unit(std::string_view name, std::string_view known,
                                           std::string_view unit);

}  // namespace host_sim
