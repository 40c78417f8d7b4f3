#include "host_sim/model/model.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <iterator>
#include <string>

#include "host_sim/model/life_interval.hpp"
#include "host_sim/model/model_tables.hpp"
#include "host_sim/model/watch.hpp"

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

std::string model_digest(const Model& model) {
  Model values = model;
  std::string text = "schema=1\n";
  for (const ModelKey& key : model_keys()) {
    if (key.table == "drive" && !values.drive) {
      continue;
    }
    const double without_negative_zero = key.value(values) + 0.0;
    fmt::format_to(std::back_inserter(text), "{}.{}={:.17g}\n", key.table, key.key,
                   without_negative_zero);
  }
  text += fmt::format("life.mean_stress={}\n", name_of(model.life.mean_stress));
  if (model.life.interval) {
    text += life_interval_text(*model.life.interval, "life.interval.");
  }
  for (const Extension& extension : model.extensions) {
    for (const Extension::Value& value : extension.values) {
      for (const double number : value.values) {
        fmt::format_to(std::back_inserter(text), "extension.{}.{}={:.17g}\n", extension.id,
                       value.name, number + 0.0);
      }
    }
  }
  if (model.watch) {
    text += watch_text(*model.watch, "watch.");
  }
  const auto* const bytes = reinterpret_cast<const Bytef*>(text.data());
  return fmt::format("{:08x}", crc32(0, bytes, static_cast<uInt>(text.size())));
}

}  // namespace host_sim
