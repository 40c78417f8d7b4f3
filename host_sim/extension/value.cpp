#include "host_sim/extension/value.hpp"

namespace host_sim {

const Extension* extension_of(std::span<const Extension> extensions, std::string_view id) {
  for (const Extension& extension : extensions) {
    if (extension.id == id) {
      return &extension;
    }
  }
  return nullptr;
}

std::span<const double> values_of(const Extension& extension, std::string_view name) {
  for (const Extension::Value& value : extension.values) {
    if (value.name == name) {
      return value.values;
    }
  }
  return {};
}

std::optional<double> value_if(const Extension& extension, std::string_view name) {
  const std::span<const double> values = values_of(extension, name);
  if (values.empty()) {
    return std::nullopt;
  }
  return values.front();
}

double value_of(const Extension& extension, std::string_view name) {
  return values_of(extension, name).front();
}

}  // namespace host_sim
