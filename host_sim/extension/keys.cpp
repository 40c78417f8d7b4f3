#include "host_sim/extension/keys.hpp"

#include <algorithm>
#include <limits>

#include "host_sim/effects/life_effect.hpp"
#include "host_sim/effects/tension_effect.hpp"

namespace host_sim {
namespace {

/// What an equation needs besides the parameters that are fitted.
struct Companion {
  std::string_view id;
  ExtensionKey key;
};

/// Where nobody has given a number and the effect cannot be evaluated without.
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

constexpr Companion kCompanions[] = {
    {"friction_temperature", {{"sheath_reference_C", "C", {-50, 150}}, 20, false}},
    {"torque_gain", {{"winding_reference_C", "C", {-50, 200}}, 20, false}},
    {"bending_fatigue", {{"wire_to_bend_ratio", "", {0, 1}}, kUnknown, false}},
    {"endurance_limit", {{"lowest_effective_N", "N", {0, 1000, true}}, kUnknown, false}},
};

/// The suffix of a name that is its unit, as files have it.
std::string_view unit_of(const effects::Parameter& parameter) {
  if (parameter.unit == "1") {
    return "";
  }
  for (const std::string_view suffix :
       {"1_K", "1_day", "s_m", "m_s", "N_m", "cycles", "rad", "A", "N", "s", "m"}) {
    if (parameter.name.ends_with(suffix)) {
      return suffix;
    }
  }
  return "";
}

ExtensionKeys keys_of(std::string_view id, std::span<const effects::Parameter> parameters,
                      bool per_pose) {
  ExtensionKeys result{id, {}};
  // A share that only says how far another parameter is off is multiplied into that one.
  const bool shared = std::ranges::any_of(parameters, &effects::Parameter::scaled_by_share);
  for (const effects::Parameter& parameter : parameters.subspan(shared ? 1 : 0)) {
    result.keys.push_back(
        {{parameter.name, unit_of(parameter), {parameter.minimum, parameter.maximum}},
         parameter.off_line ? std::optional<double>(0) : std::nullopt,
         per_pose});
  }
  for (const Companion& companion : kCompanions) {
    if (companion.id == id) {
      result.keys.push_back(companion.key);
    }
  }
  return result;
}

std::vector<ExtensionKeys> all_keys() {
  std::vector<ExtensionKeys> all;
  for (const auto& effect : effects::tension_effects()) {
    all.push_back(keys_of(effect->id(), effect->parameters(), effect->per_pose()));
  }
  for (const auto& effect : effects::life_effects()) {
    all.push_back(keys_of(effect->id(), effect->parameters(), false));
  }
  std::ranges::sort(all, {}, &ExtensionKeys::id);
  return all;
}

}  // namespace

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

}  // namespace host_sim
