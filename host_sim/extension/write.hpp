#pragma once

#include <span>
#include <string>

#include "host_sim/model/model.hpp"

namespace host_sim {

/// The tables [extension.<id>] as they stand at the end of a model.toml. What read_extensions()
/// makes of them are the same numbers, to the last bit.
/// @pre all numbers are finite
std::string toml_text(std::span<const Extension> extensions);

}  // namespace host_sim
