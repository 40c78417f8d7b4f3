#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "host_sim/extension/extension.hpp"

namespace host_sim {

/// The extension of an effect; null where the model has none.
const Extension* extension_of(std::span<const Extension> extensions, std::string_view id);

/// The numbers of that name; empty where it has none.
std::span<const double> values_of(const Extension& extension, std::string_view name);

/// The number of that name; nothing where it has none.
std::optional<double> value_if(const Extension& extension, std::string_view name);

/// The number of that name. @pre it has one
double value_of(const Extension& extension, std::string_view name);

}  // namespace host_sim
