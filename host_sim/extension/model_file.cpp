#include "host_sim/extension/model_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "hal/files/input_file.hpp"
#include "host_sim/effects/life_effect.hpp"
#include "host_sim/effects/tension/tension_effect.hpp"
#include "host_sim/model/model.hpp"
#include "host_sim/model/model_tables.hpp"

namespace host_sim {

using hal::files::describe;
using hal::files::file_name;
using hal::files::NumberKey;
using hal::files::parse_toml;
using hal::files::range_text;
using hal::files::read_text_file;
using hal::files::toml_float;
using hal::files::TomlTable;

namespace {

constexpr std::string_view kExtension = "extension";

std::optional<double> number_of(const toml::node& node) {
  return node.is_number() ? node.value<double>() : std::nullopt;
}

/// An array of numbers in their range.
std::vector<double> numbers(const TomlTable& table, const NumberKey& key, std::size_t most) {
  const std::string accepted =
      fmt::format("{} an array of 1..{} numbers, each {}", key.name, most, range_text(key.range));
  const toml::node& node = table.node(key.name, accepted);
  const toml::array* const array = node.as_array();
  if (array == nullptr || array->empty() || array->size() > most) {
    table.fail(table.place_of(key.name),
               array == nullptr ? fmt::format("{} is {}", key.name, describe(node))
                                : fmt::format("{} has {} numbers", key.name, array->size()),
               accepted);
  }
  std::vector<double> values;
  for (const toml::node& element : *array) {
    const auto value = number_of(element);
    if (!value || !key.range.contains(*value)) {
      table.fail(element.source().begin, fmt::format("{} holds {}", key.name, describe(element)),
                 accepted);
    }
    values.push_back(*value);
  }
  return values;
}

void require_rising(const TomlTable& table, std::string_view name,
                    const std::vector<double>& values, std::string_view accepted) {
  if (!std::ranges::is_sorted(values, std::ranges::less_equal{})) {
    table.fail(table.place_of(name), fmt::format("{} do not rise", name), accepted);
  }
}

/// As many as there are of another.
std::vector<double> as_many(const TomlTable& table, const NumberKey& key, std::size_t most,
                            std::string_view other, std::size_t count) {
  std::vector<double> values = numbers(table, key, most);
  if (values.size() != count) {
    table.fail(table.place_of(key.name), fmt::format("{} has {} numbers", key.name, values.size()),
               fmt::format("as many as {}: {}", other, count));
  }
  return values;
}

/// One number where the table knows no bend angles, else one for each.
void read_per_pose(const TomlTable& table, const NumberKey& key, Extension& extension) {
  if (!table.has(kBendAngles.name)) {
    extension.values.push_back({std::string(key.name), {table.number(key)}});
    return;
  }
  const std::vector<double> angles_deg = numbers(table, kBendAngles, kMostBendAngles);
  require_rising(table, kBendAngles.name, angles_deg,
                 "bend angles from the smallest to the largest, each once");
  const std::vector<double> values =
      as_many(table, key, kMostBendAngles, kBendAngles.name, angles_deg.size());
  extension.values.push_back({std::string(key.name), values});
  extension.values.push_back({std::string(kBendAngles.name), angles_deg});
}

void read_key(const TomlTable& table, const effects::TableKey& key, Extension& extension) {
  if (key.per_pose) {
    read_per_pose(table, key.number, extension);
  } else if (table.has(key.number.name) || !key.otherwise) {
    extension.values.push_back({std::string(key.number.name), {table.number(key.number)}});
  } else if (!std::isnan(*key.otherwise)) {
    extension.values.push_back({std::string(key.number.name), {*key.otherwise}});
  }
}

void refuse_unknown_keys(const TomlTable& table, const ExtensionKeys& keys) {
  std::vector<NumberKey> numbers;
  bool per_pose = false;
  for (const effects::TableKey& key : keys.keys) {
    numbers.push_back(key.number);
    per_pose = per_pose || key.per_pose;
  }
  if (per_pose) {
    numbers.push_back(kBendAngles);
  }
  table.refuse_unknown_keys(numbers, {});
}

/// A law of wear needs its exponent, one of run-in its number of cycles.
void check_wear(const TomlTable& table, const Extension& extension) {
  constexpr double kLeastRunIn_cycles = 1;
  if (value_of(extension, "wear_exponent") == 0 &&
      value_of(extension, "run_in_cycles") < kLeastRunIn_cycles) {
    table.fail(table.place_of("run_in_cycles"),
               fmt::format("run_in_cycles is {} with wear_exponent 0",
                           value_of(extension, "run_in_cycles")),
               "wear_exponent above 0, or run_in_cycles 1 or more");
  }
}

/// A table of velocity that says nothing is a mistake; Stribeck friction needs its velocity.
void check_velocity(const TomlTable& table, const Extension& extension) {
  if (extension.values.empty()) {
    table.fail(table.place(), "no key in [extension.friction_velocity]",
               "viscous_N_s_m, viscous_friction_s_m, or stribeck_friction and "
               "stribeck_velocity_m_s");
  }
  if (value_if(extension, "stribeck_friction").value_or(0) != 0 &&
      !value_if(extension, "stribeck_velocity_m_s")) {
    table.fail(table.place_of("stribeck_friction"), "stribeck_friction without its velocity",
               "stribeck_velocity_m_s beside it");
  }
}

/// What keys of a table say together.
struct Check {
  std::string_view id;
  void (*check)(const TomlTable& table, const Extension& extension);
};

constexpr Check kChecks[] = {{"friction_velocity", check_velocity}, {"friction_wear", check_wear}};

/// A covariate with its knots, and a force for each direction at each of them.
Extension read_empirical(const TomlTable& table) {
  constexpr std::string_view kOne =
      "exactly one of output_tension_N, position_m, speed_m_s, travel_m";
  const NumberKey* covariate = nullptr;
  for (const NumberKey& key : kEmpiricalCovariates) {
    if (table.has(key.name) && covariate != nullptr) {
      table.fail(table.place_of(key.name), fmt::format("{} beside {}", key.name, covariate->name),
                 kOne);
    }
    covariate = table.has(key.name) ? &key : covariate;
  }
  if (covariate == nullptr) {
    table.fail(table.place(), "no covariate in [extension.empirical]", kOne);
  }
  const std::vector<double> knots = numbers(table, *covariate, kMostKnots);
  require_rising(table, covariate->name, knots,
                 "knots from the smallest to the largest, each once");
  Extension extension{std::string(kEmpirical), {{std::string(covariate->name), knots}}};
  for (const NumberKey& force : kEmpiricalForces) {
    extension.values.push_back({std::string(force.name),
                                as_many(table, force, kMostKnots, covariate->name, knots.size())});
  }
  return extension;
}

Extension read_extension(const TomlTable& table, const ExtensionKeys& keys) {
  refuse_unknown_keys(table, keys);
  if (keys.id == kEmpirical) {
    return read_empirical(table);
  }
  Extension extension{std::string(keys.id), {}};
  for (const effects::TableKey& key : keys.keys) {
    read_key(table, key, extension);
  }
  const auto* const check = std::ranges::find(kChecks, keys.id, &Check::id);
  if (check != std::end(kChecks)) {
    check->check(table, extension);
  }
  return extension;
}

/// What an equation of a life needs besides the parameters that are fitted.
struct Companion {
  std::string_view id;
  effects::TableKey key;
};

constexpr Companion kCompanions[] = {
    {"bending_fatigue", {{"wire_to_bend_ratio", "", {0, 1}}, effects::TableKey::kUnknown}},
    {"endurance_limit", {{"lowest_effective_N", "N", {0, 1e6, true}}, effects::TableKey::kUnknown}},
};

/// The suffix of a name that is its unit, as files have it.
std::string_view unit_of(const effects::Parameter& parameter) {
  if (parameter.unit == "1") {
    return "";
  }
  for (const std::string_view suffix : {"1_day", "N"}) {
    if (parameter.name.ends_with(suffix)) {
      return suffix;
    }
  }
  return "";
}

ExtensionKeys keys_of(const effects::LifeEffect& effect) {
  ExtensionKeys result{effect.id(), {}};
  for (const effects::Parameter& parameter : effect.parameters()) {
    result.keys.push_back(
        {{parameter.name, unit_of(parameter), {parameter.minimum, parameter.maximum}},
         parameter.off_line ? std::optional<double>(0) : std::nullopt});
  }
  for (const Companion& companion : kCompanions) {
    if (companion.id == effect.id()) {
      result.keys.push_back(companion.key);
    }
  }
  return result;
}

ExtensionKeys empirical() {
  ExtensionKeys keys{kEmpirical, {}};
  for (const NumberKey& key : kEmpiricalCovariates) {
    keys.keys.push_back({key, effects::TableKey::kUnknown});
  }
  for (const NumberKey& key : kEmpiricalForces) {
    keys.keys.push_back({key});
  }
  return keys;
}

std::vector<ExtensionKeys> all_keys() {
  std::vector<ExtensionKeys> all;
  for (const effects::TensionEffect* const effect : effects::tension_effects()) {
    if (!effect->table.empty()) {
      all.push_back({effect->id, {effect->table.begin(), effect->table.end()}});
    }
  }
  for (const auto& effect : effects::life_effects()) {
    all.push_back(keys_of(*effect));
  }
  all.push_back(empirical());
  std::ranges::sort(all, {}, &ExtensionKeys::id);
  return all;
}

/// Whether a name stands for an array even where it holds one number.
bool is_array(const Extension& extension, const Extension::Value& value) {
  if (value.name == kBendAngles.name || value.values.size() > 1 || extension.id == kEmpirical) {
    return true;
  }
  for (const Extension::Value& other : extension.values) {
    if (other.name == kBendAngles.name) {
      return true;
    }
  }
  return false;
}

std::string value_text(const Extension& extension, const Extension::Value& value) {
  if (!is_array(extension, value)) {
    return toml_float(value.values.front());
  }
  std::vector<std::string> numbers;
  for (const double number : value.values) {
    numbers.push_back(toml_float(number));
  }
  return fmt::format("[{}]", fmt::join(numbers, ", "));
}

/// What the target holds relative to the ultimate tension is at most that.
void check_forces(const TomlTable& table, const Extension& extension, double ultimate_tension_N) {
  for (const std::string_view name : {"preload_N", "zero_N", "pulling_N", "letting_go_N"}) {
    for (const double force_N : values_of(extension, name)) {
      if (std::abs(force_N) > ultimate_tension_N) {
        table.fail(table.place_of(name), fmt::format("{} is {}", name, force_N),
                   fmt::format("up to ultimate_tension_N, {}", ultimate_tension_N));
      }
    }
  }
}

}  // namespace

std::vector<Extension> read_extensions(const TomlTable& extension) {
  std::vector<std::string_view> ids;
  for (const ExtensionKeys& keys : extension_keys()) {
    ids.push_back(keys.id);
  }
  extension.refuse_unknown_keys({}, ids);
  std::vector<Extension> read;
  for (const ExtensionKeys& keys : extension_keys()) {
    if (extension.has(keys.id)) {
      read.push_back(read_extension(extension.table(keys.id), keys));
    }
  }
  return read;
}

Model parse_extended_model(std::string_view text, std::string_view name) {
  const toml::table values = parse_toml(text, name);
  const TomlTable top(name, values, "", {});
  Model model = nominal_model_of(top, std::span(&kExtension, 1));
  if (top.has(kExtension)) {
    const TomlTable tables = top.table(kExtension);
    model.extensions = read_extensions(tables);
    for (const Extension& extension : model.extensions) {
      check_forces(tables.table(extension.id), extension, model.cable.ultimate_tension_N);
    }
  }
  return model;
}

Model read_extended_model(const std::filesystem::path& path) {
  return parse_extended_model(read_text_file(path, "a model file (TOML) of at most 1 MiB"),
                              file_name(path));
}

std::span<const ExtensionKeys> extension_keys() {
  static const std::vector<ExtensionKeys> kAll = all_keys();
  return kAll;
}

const ExtensionKeys* extension_keys(std::string_view id) {
  for (const ExtensionKeys& keys : extension_keys()) {
    if (keys.id == id) {
      return &keys;
    }
  }
  return nullptr;
}

bool is_within_bounds(const Extension& extension) {
  const std::vector<effects::TableKey>& keys = extension_keys(extension.id)->keys;
  return std::ranges::all_of(extension.values, [&](const Extension::Value& value) {
    const auto key = std::ranges::find(
        keys, value.name, [](const effects::TableKey& one) { return one.number.name; });
    const NumberKey& number = key == keys.end() ? kBendAngles : key->number;
    return value.values.size() <= kMostBendAngles &&
           std::ranges::all_of(value.values,
                               [&](double one) { return number.range.contains(one); });
  });
}

std::string toml_text(std::span<const Extension> extensions) {
  std::string text;
  for (const Extension& extension : extensions) {
    text += fmt::format("{}[extension.{}]\n", text.empty() ? "" : "\n", extension.id);
    for (const Extension::Value& value : extension.values) {
      text += fmt::format("{} = {}\n", value.name, value_text(extension, value));
    }
  }
  return text;
}

}  // namespace host_sim
