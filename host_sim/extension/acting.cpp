#include "host_sim/extension/acting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "host_sim/extension/life.hpp"
#include "host_sim/extension/model_file.hpp"
#include "host_sim/extension/tension.hpp"
#include "host_sim/model/model.hpp"

namespace host_sim {

using hal::files::InputKind;
using enum hal::files::ProfileColumnId;
using hal::files::profile_columns;
using hal::files::ProfileChannels;
using hal::files::ProfileColumnId;

namespace {

/// An effect that is evaluated sample by sample.
struct OnLine {
  std::string_view id;
  InputKind kind;
  std::optional<ProfileColumnId> channel;  ///< that it needs beside the input
};

constexpr std::array<OnLine, 13> kOnLine{{
    {"bend_angle", InputKind::kOutputTension, std::nullopt},
    {"current_offset", InputKind::kMotorCurrent, std::nullopt},
    {"friction_load", InputKind::kOutputTension, std::nullopt},
    {"friction_position", InputKind::kOutputTension, kMotorAngle},
    {"friction_preload", InputKind::kOutputTension, std::nullopt},
    {"friction_temperature", InputKind::kOutputTension, kSheathTemperature},
    {"friction_velocity", InputKind::kOutputTension, kTendonVelocity},
    {"friction_wear", InputKind::kOutputTension, kTendonVelocity},
    {"gear_asymmetry", InputKind::kMotorCurrent, kTendonVelocity},
    {"load_cell_zero", InputKind::kOutputTension, std::nullopt},
    {"presliding", InputKind::kOutputTension, kTendonVelocity},
    {"torque_gain", InputKind::kMotorCurrent, kWindingTemperature},
    {"torque_ripple", InputKind::kMotorCurrent, kMotorAngle},
}};

struct OffLine {
  std::string_view id, why;
};

constexpr std::array<OffLine, 6> kOffLine{{
    {"ageing", "needs a calendar, which a controller does not have"},
    {"compliance", "needs the rate of the tension before friction turns over"},
    {"load_sequence", "needs the order of the cycles, which a rainflow count gives up"},
    {"lot_frailty", "scatter between lots, which no one tendon shows"},
    {"second_mode", "a second life law beside the one that is counted"},
    {"slack", "needs the travel since each reversal to a fraction of a millimetre"},
}};

std::string_view prose_of(InputKind kind) {
  switch (kind) {
    case InputKind::kInputTension:
      return "an input tension";
    case InputKind::kMotorCurrent:
      return "a motor current";
    case InputKind::kOutputTension:
      return "an output tension";
  }
  return "";
}

std::string not_of_kind(InputKind needed, InputKind given) {
  return fmt::format("acts on {}, and the input is {}", prose_of(needed), prose_of(given));
}

/// A lag is that of the output where it is positive, else that of the current.
OnLine lag(const Extension& extension) {
  return {extension.id,
          value_of(extension, "lag_s") > 0 ? InputKind::kOutputTension : InputKind::kMotorCurrent,
          std::nullopt};
}

/// By what it is written over.
OnLine empirical_correction(const Extension& extension) {
  const bool position = kEmpiricalCovariates[empirical_covariate(extension)].name == "position_m";
  return {extension.id, InputKind::kOutputTension, position ? kMotorAngle : kTendonVelocity};
}

std::optional<OnLine> on_line(const Extension& extension) {
  if (extension.id == kEmpirical) {
    return empirical_correction(extension);
  }
  if (extension.id == "filter_lag") {
    return lag(extension);
  }
  for (const OnLine& effect : kOnLine) {
    if (effect.id == extension.id) {
      return effect;
    }
  }
  return std::nullopt;
}

std::string why_off_line(std::string_view id) {
  for (const OffLine& effect : kOffLine) {
    if (effect.id == id) {
      return std::string(effect.why);
    }
  }
  return "not known";
}

/// An effect on the damage of a cycle, whatever the input.
struct OnDamage {
  std::string_view id;
  std::string_view needed;  ///< in its table, which may lack it
  std::optional<double> (*given)(const Extension& extension) = nullptr;
};

constexpr std::array<OnDamage, 3> kOnDamage{{
    {"bending_fatigue", "wire_to_bend_ratio", bending_amplitude_N},
    {"endurance_limit", "lowest_effective_N", endurance_limit_N},
    {"mean_stress", ""},
}};

/// Why an effect does not act; empty where it does.
std::string why_not(const Extension& extension, const Model& model, InputKind kind,
                    const ProfileChannels& channels) {
  const auto* const on_damage = std::ranges::find(kOnDamage, extension.id, &OnDamage::id);
  if (on_damage != kOnDamage.end()) {
    const bool acts = on_damage->given == nullptr || on_damage->given(extension);
    return acts ? "" : fmt::format("needs {} in its table", on_damage->needed);
  }
  const std::optional<OnLine> effect = on_line(extension);
  if (!effect) {
    return "not evaluated on line: " + why_off_line(extension.id);
  }
  if (effect->kind != kind) {
    return not_of_kind(effect->kind, kind);
  }
  if (effect->channel && !channels[*effect->channel]) {
    return fmt::format("needs {}", profile_columns()[*effect->channel].name);
  }
  if (effect->channel == kMotorAngle && effect->kind == InputKind::kOutputTension && !model.drive) {
    return "needs [drive] for the position of the tendon";
  }
  return "";
}

}  // namespace

Acting acting_extensions(const Model& model, InputKind kind, const ProfileChannels& channels) {
  Acting acting;
  for (const Extension& extension : model.extensions) {
    std::string why = why_not(extension, model, kind, channels);
    if (why.empty()) {
      acting.extensions.push_back(extension);
    } else {
      acting.others.push_back({extension.id, std::move(why)});
    }
  }
  return acting;
}

}  // namespace host_sim
