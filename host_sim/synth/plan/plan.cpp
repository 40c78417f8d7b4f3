#include "host_sim/synth/plan/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "hal/files/input_file.hpp"
#include "host_sim/model/model_tables.hpp"
#include "host_sim/synth/life_departures.hpp"
#include "host_sim/synth/plan/tables.hpp"
#include "host_sim/synth/tension/departures.hpp"
#include "host_sim/synth/two_sided/kinds.hpp"

namespace host_sim::synth {

using hal::files::describe;
using hal::files::file_name;
using hal::files::NumberKey;
using hal::files::NumberRange;
using hal::files::parse_toml;
using hal::files::read_text_file;
using hal::files::TomlTable;

namespace {

constexpr NumberKey kLogSd{"log_tension_sd", "", {0, 1}};
constexpr NumberKey kAr1{"ar1", "", {-0.999, 0.999}};
constexpr NumberKey kOutputSd{"output_relative_sd", "", {0, 1}};
constexpr NumberKey kInputSd{"input_relative_sd", "", {0, 1}};
constexpr NumberKey kOutputFloor{"output_absolute_N", "N", {0, 10}};
constexpr NumberKey kInputFloor{"input_absolute_N", "N", {0, 10}};
constexpr NumberKey kCurrentFloor{"input_absolute_A", "A", {0, 10}};
constexpr NumberKey kOutputAr1{"output_ar1", "", {-0.999, 0.999}};
constexpr NumberKey kInputAr1{"input_ar1", "", {-0.999, 0.999}};
constexpr NumberKey kInstantJitter{"jitter_s", "s", {0, 1}};
constexpr NumberKey kDof{"student_t_dof", "", {2, 1000, true}};
constexpr NumberKey kTensionStep{"tension_resolution_N", "N", {0, 10}};
constexpr NumberKey kCurrentStep{"current_resolution_A", "A", {0, 10}};
constexpr NumberKey kVelocitySd{"velocity_sd_m_s", "m_s", {0, 1}};
constexpr NumberKey kVelocityStep{"velocity_resolution_m_s", "m_s", {0, 1}};
constexpr NumberKey kTemperatureSd{"temperature_sd_C", "C", {0, 50}};
constexpr NumberKey kJitter{"clock_jitter_s", "s", {0, 1}};
constexpr NumberKey kDrift{"clock_drift_ppm", "ppm", {-100'000, 100'000}};
constexpr std::array kNoise{
    kLogSd,        kAr1,        kOutputSd,     kInputSd,       kOutputFloor, kInputFloor,
    kCurrentFloor, kOutputAr1,  kInputAr1,     kInstantJitter, kDof,         kTensionStep,
    kCurrentStep,  kVelocitySd, kVelocityStep, kTemperatureSd, kJitter,      kDrift};

constexpr NumberKey kGainSd{"log_gain_sd", "", {0, 0.5}};
constexpr NumberKey kFrictionSd{"friction_sd", "", {0, 0.2}};
constexpr std::array kScatter{kGainSd, kFrictionSd};

constexpr NumberRange kTime_s{0.01, 1e6};
constexpr NumberRange kHeating_K_W{0, 1e4};
constexpr NumberKey kRoom{"room_C", "C", {-50, 100}};
constexpr NumberKey kSheathTime{"sheath_time_constant_s", "s", kTime_s};
constexpr NumberKey kSheathHeating{"sheath_K_per_W", "K_per_W", kHeating_K_W};
constexpr NumberKey kWindingTime{"winding_time_constant_s", "s", kTime_s};
constexpr NumberKey kWindingHeating{"winding_K_per_W", "K_per_W", kHeating_K_W};
constexpr NumberKey kResistance{"winding_resistance_ohm", "ohm", {0, 1e4}};
constexpr std::array kThermal{kRoom,        kSheathTime,     kSheathHeating,
                              kWindingTime, kWindingHeating, kResistance};

Noise noise_in(const TomlTable& table) {
  table.refuse_unknown_keys(kNoise, {});
  Noise noise;
  const double both_sd = number_or(table, kLogSd, 0);
  const double both_ar1 = number_or(table, kAr1, 0);
  noise.output = {number_or(table, kOutputSd, both_sd), number_or(table, kOutputFloor, 0), 0,
                  number_or(table, kOutputAr1, both_ar1)};
  noise.input = {number_or(table, kInputSd, both_sd), number_or(table, kInputFloor, 0),
                 number_or(table, kCurrentFloor, 0), number_or(table, kInputAr1, both_ar1)};
  noise.jitter_s = number_or(table, kInstantJitter, 0);
  noise.student_t_dof = number_or(table, kDof, 0);
  noise.tension_resolution_N = number_or(table, kTensionStep, 0);
  noise.current_resolution_A = number_or(table, kCurrentStep, 0);
  noise.velocity_sd_m_s = number_or(table, kVelocitySd, 0);
  noise.velocity_resolution_m_s = number_or(table, kVelocityStep, 0);
  noise.temperature_sd_C = number_or(table, kTemperatureSd, 0);
  noise.clock_jitter_s = number_or(table, kJitter, 0);
  noise.clock_drift_ppm = number_or(table, kDrift, 0);
  return noise;
}

ScatterPlan scatter_in(const TomlTable& table) {
  table.refuse_unknown_keys(kScatter, {});
  return {number_or(table, kGainSd, 0), number_or(table, kFrictionSd, 0)};
}

Thermal thermal_in(const TomlTable& table) {
  table.refuse_unknown_keys(kThermal, {});
  Thermal thermal;
  thermal.room_C = number_or(table, kRoom, thermal.room_C);
  thermal.sheath_time_constant_s = number_or(table, kSheathTime, thermal.sheath_time_constant_s);
  thermal.sheath_K_per_W = number_or(table, kSheathHeating, thermal.sheath_K_per_W);
  thermal.winding_time_constant_s = number_or(table, kWindingTime, thermal.winding_time_constant_s);
  thermal.winding_K_per_W = number_or(table, kWindingHeating, thermal.winding_K_per_W);
  thermal.winding_resistance_ohm = number_or(table, kResistance, thermal.winding_resistance_ohm);
  return thermal;
}

Values values_in(const TomlTable& table, const std::vector<Parameter>& parameters,
                 const std::vector<Choice>& choices) {
  std::vector<NumberKey> keys;
  std::vector<std::string_view> others;
  std::transform(parameters.begin(), parameters.end(), std::back_inserter(keys),
                 [](const Parameter& parameter) { return parameter.key; });
  std::transform(choices.begin(), choices.end(), std::back_inserter(others),
                 [](const Choice& choice) { return choice.name; });
  table.refuse_unknown_keys(keys, others);
  Values values;
  for (const Parameter& parameter : parameters) {
    if (parameter.standard && !table.has(parameter.key.name)) {
      values.set(parameter.key.name, {*parameter.standard});
    } else if (parameter.list) {
      values.set(parameter.key.name, numbers(table, parameter.key));
    } else {
      values.set(parameter.key.name, {table.number(parameter.key)});
    }
  }
  for (const Choice& choice : choices) {
    values.choose(choice.name, choice.names[choice_of(table, choice.name, choice.names)]);
  }
  return values;
}

template <class Kinds>
void add_ids(const Kinds& kinds, std::vector<std::string_view>& ids) {
  for (const auto& kind : kinds) {
    ids.push_back(kind.id);
  }
}

template <class Kinds>
void read(const TomlTable& table, const Kinds& kinds, const Departure& like,
          std::vector<Departure>& departures) {
  for (const auto& kind : kinds) {
    if (table.has(kind.id)) {
      Departure one = like;
      one.id = kind.id;
      one.values = values_in(table.table(kind.id), kind.parameters, kind.choices);
      departures.push_back(std::move(one));
    }
  }
}

/// The departures of [effects], or of [outside].
std::vector<Departure> departures_in(const TomlTable& table, bool outside, bool two_sided) {
  const auto tension = outside ? outside_tension_kinds() : tension_kinds();
  const auto signed_force = outside ? outside_two_sided_kinds() : two_sided_kinds();
  const auto life = outside ? outside_life_kinds() : life_kinds();
  std::vector<std::string_view> ids;
  if (two_sided) {
    add_ids(signed_force, ids);
  } else {
    add_ids(tension, ids);
  }
  add_ids(life, ids);
  table.refuse_unknown_keys({}, ids);
  std::vector<Departure> departures;
  Departure like;
  like.outside = outside;
  if (two_sided) {
    read(table, signed_force, like, departures);
  } else {
    read(table, tension, like, departures);
  }
  like.of_life = true;
  read(table, life, like, departures);
  return departures;
}

constexpr std::array<std::string_view, 5> kOfDrive{
    "current_offset", "torque_gain", "gear_asymmetry", "torque_ripple", "rotor_inertia"};

void check_departure(const TomlTable& top, const SynthPlan& plan, const Departure& departure) {
  const std::string_view above = departure.outside ? "outside" : "effects";
  const TomlTable table = top.table(above).table(departure.id);
  const auto needs = [&](bool given, std::string_view what) {
    if (!given) {
      table.fail(table.place(), fmt::format("[{}.{}] without {}", above, departure.id, what),
                 fmt::format("{}, which it needs", what));
    }
  };
  needs(departure.of_life ? plan.lives.has_value() : plan.recordings.has_value(),
        departure.of_life ? "[lives]" : "[recordings]");
  if (std::find(kOfDrive.begin(), kOfDrive.end(), departure.id) != kOfDrive.end()) {
    needs(plan.model.drive.has_value(), "[model.drive]");
  }
  if (departure.id == "load_cell_cross_talk") {
    needs(plan.recordings->motion.pose_sway_deg > 0, "pose_sway_deg above 0 in [recordings]");
  }
  if (departure.id == "rig_bias") {
    needs(plan.lives->rigs > 1, "rigs above 1 in [lives]");
  }
  if (departure.id == "bending_fatigue") {
    const auto& levels = plan.lives->levels;
    needs(std::all_of(levels.begin(), levels.end(),
                      [](const LifeLevel& level) { return level.load.wire_to_bend_ratio > 0; }),
          "wire_to_bend_ratio in each [[lives.level]]");
  }
}

/// Throws InputError where the parts of a plan do not agree; `top` is the whole file.
void check_agreement(const TomlTable& top, const SynthPlan& plan) {
  if (!plan.recordings && !plan.lives) {
    top.fail({}, "neither recordings nor lives", "a table [recordings], [lives] or both");
  }
  if (plan.recordings) {
    check_recordings(top, plan);
  }
  if (plan.lives) {
    check_lives(top, plan);
  }
  for (const Departure& departure : plan.departures) {
    check_departure(top, plan, departure);
  }
}

constexpr std::array<std::string_view, 10> kTop{"schema",     "campaign", "model",   "thermal",
                                                "recordings", "noise",    "scatter", "lives",
                                                "effects",    "outside"};
constexpr std::array<std::string_view, 2> kCampaign{"name", "two_sided"};

void append(std::vector<Departure>& to, std::vector<Departure> from) {
  for (Departure& departure : from) {
    to.push_back(std::move(departure));
  }
}

}  // namespace

[[noreturn]] void fail_for_model(const TomlTable& top, std::string_view table,
                                 std::string_view why) {
  top.fail(top.place_of("model"), fmt::format("no table [model.{}]", table),
           fmt::format("[model.{}], which {} needs", table, why));
}

SynthPlan parse_synth_plan(std::string_view text, std::string_view name) {
  const toml::table values = parse_toml(text, name);
  const TomlTable top(name, values, "", {});
  check_schema(top);
  top.refuse_unknown_keys({}, kTop);
  SynthPlan plan;
  plan.file = name;
  const TomlTable campaign = top.table("campaign");
  campaign.refuse_unknown_keys({}, kCampaign);
  plan.name = campaign.text("name");
  plan.two_sided = campaign.flag("two_sided");
  plan.model = known_tables_of(top.table("model"));
  const auto read = [&](std::string_view key, const auto& into) {
    if (top.has(key)) {
      into(top.table(key));
    }
  };
  read("thermal", [&](const TomlTable& table) { plan.thermal = thermal_in(table); });
  read("recordings", [&](const TomlTable& table) {
    plan.recordings.emplace(recordings_in(table, plan.two_sided));
  });
  read("noise", [&](const TomlTable& table) { plan.noise = noise_in(table); });
  read("scatter", [&](const TomlTable& table) { plan.scatter = scatter_in(table); });
  read("lives", [&](const TomlTable& table) { plan.lives.emplace(lives_in(table)); });
  read("effects", [&](const TomlTable& table) {
    append(plan.departures, departures_in(table, false, plan.two_sided));
  });
  read("outside", [&](const TomlTable& table) {
    append(plan.departures, departures_in(table, true, plan.two_sided));
  });
  check_agreement(top, plan);
  return plan;
}

SynthPlan read_synth_plan(const std::filesystem::path& path) {
  return parse_synth_plan(read_text_file(path, "a plan (TOML) of at most 1 MiB"), file_name(path));
}

}  // namespace host_sim::synth
