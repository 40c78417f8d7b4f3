#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "host_sim/diagnose/force/force_model.hpp"
#include "host_sim/extension/model_file.hpp"

/// The effects of the catalogue as the forward model has them: a namespace for each law, and its
/// place in the list at the end.
namespace host_sim::diagnose {
namespace {

using Parameters = std::vector<ForceParameter>;
using Numbers = std::span<const double>;

/// By the names of the parameters.
Extension by_name(std::string_view id, Numbers parameters, const Parameters& names) {
  Extension extension{std::string(id), {}};
  for (std::size_t i = 0; i < names.size(); ++i) {
    extension.values.push_back({names[i].name, {parameters[i]}});
  }
  return extension;
}

/// The same as the table of a law that has these.
template <Parameters (*kParameters)(const ForceScales&)>
Extension written(std::string_view id, Numbers numbers, const ForceScales& scales) {
  return by_name(id, numbers, kParameters(scales));
}

/// kappa of laws of the speed.
ForceParameter viscous_friction(const ForceScales& scales) {
  const double speed_m_s = scales.speed_m_s;
  return {"viscous_friction_s_m", "s/m", -1 / speed_m_s, 1 / speed_m_s, {0.01 / speed_m_s}};
}

/// b of laws of slack.
ForceParameter slack_length(const ForceScales& scales) {
  const double stroke_m = scales.stroke_m;
  return {"slack_m", "m", 0, 0.3 * stroke_m, {0.01 * stroke_m, 0.03 * stroke_m, 0.1 * stroke_m},
          true};
}

/// k of laws of a tendon that stretches.
/// @param starts in units of the rms force over the stroke
ForceParameter stiffness(std::string name, const ForceScales& scales, std::vector<double> starts) {
  const double unit_N_m = scales.force_N / scales.stroke_m;
  for (double& start : starts) {
    start *= unit_N_m;
  }
  return {std::move(name), "N/m", unit_N_m, 1e4 * unit_N_m, std::move(starts)};
}

/// ln of what a loose tendon lacks at least: one that has nearly all of its force is not loose.
constexpr double kLeastDrop = 0.04;
constexpr double kOfStep = 0.04;  ///< of the time between samples, which times are resolved by

bool has_current(const ForceRecord& record) {
  return record.input_N_per_A > 0;
}

bool pulls_alone(const ForceRecord& record) {
  return record.pulls_alone;
}

bool works_both_ways(const ForceRecord& record) {
  return !record.pulls_alone;
}

namespace preload {

Parameters parameters(const ForceScales& scales) {
  return {{"preload_N", "N", 0, 10 * scales.larger_N(), {0.2 * scales.larger_N()}}};
}

constexpr ForceEffect kEffect{
    "friction_preload",
    "load-independent friction",
    "+ F s",
    "friction that does not fall with the load loads the tendon in every cycle, small ones most",
    nullptr,
    parameters,
    [](Numbers numbers, ForceValues& values) { values.preload_N = numbers[0]; },
    written<parameters>,
    ForceEffect::Of::friction};

}  // namespace preload

namespace velocity {

Parameters parameters(const ForceScales& scales) {
  const double force_N = scales.larger_N();
  const double speed_m_s = scales.speed_m_s;
  return {{"viscous_N_s_m", "N s/m", 0, 10 * force_N / speed_m_s, {0.05 * force_N / speed_m_s}},
          viscous_friction(scales)};
}

constexpr ForceEffect kEffect{"friction_velocity",
                              "viscous friction",
                              "+ (c + kappa phi |T|) |v| s",
                              "fast strokes load the tendon more than slow ones of the same load",
                              nullptr,
                              parameters,
                              [](Numbers numbers, ForceValues& values) {
                                values.viscous_N_s_m = numbers[0];
                                values.viscous_friction_s_m = numbers[1];
                              },
                              written<parameters>,
                              ForceEffect::Of::friction};

}  // namespace velocity

namespace stribeck {

/// A model that is written has the velocity within these bounds. Slower than friction turns over it
/// would be that.
Parameters parameters(const ForceScales& scales) {
  constexpr double kLeast_m_s = 0.002;
  constexpr double kMost_m_s = 0.1;
  const double speed_m_s = scales.speed_m_s;
  const double least_m_s = std::max(kLeast_m_s, 2 * scales.turn_over_m_s);
  if (least_m_s >= kMost_m_s) {
    return {};
  }
  return {
      viscous_friction(scales),
      {"stribeck_friction", "1", -0.5, 0.5, {0.02}},
      {"stribeck_velocity_m_s", "m/s", least_m_s, kMost_m_s, {0.1 * speed_m_s, 0.3 * speed_m_s}}};
}

constexpr ForceEffect kEffect{
    "friction_velocity",
    "viscous and Stribeck friction",
    "mu + (mu_s - mu) exp(-|v|/v_s) + kappa |v|",
    "the same grip does more damage at the speed where friction is larger",
    pulls_alone,
    parameters,
    [](Numbers numbers, ForceValues& values) {
      values.viscous_friction_s_m = numbers[0];
      values.stribeck_friction = numbers[1];
      values.stribeck_velocity_m_s = numbers[2];
    },
    written<parameters>,
    ForceEffect::Of::friction};

}  // namespace stribeck

namespace presliding {

Parameters parameters(const ForceScales& scales) {
  const double stroke_m = scales.stroke_m;
  return {{"presliding_length_m",
           "m",
           5e-4 * stroke_m,
           0.5 * stroke_m,
           {0.01 * stroke_m, 0.05 * stroke_m, 0.15 * stroke_m}}};
}

constexpr ForceEffect kEffect{
    "presliding",
    "presliding",
    "s becomes z, dz/dx = (sgn(dx) - z)/l",
    "short strokes see less friction than long ones",
    nullptr,
    parameters,
    [](Numbers numbers, ForceValues& values) { values.presliding_m = numbers[0]; },
    written<parameters>,
    ForceEffect::Of::friction};

}  // namespace presliding

namespace elastic_presliding {

/// A length that friction turns over by is how far it stretches a tendon of this stiffness.
Parameters parameters(const ForceScales& scales) {
  return {stiffness("presliding_stiffness_N_m", scales, {5, 100})};
}

constexpr ForceEffect kEffect{
    "presliding",
    "presliding over a length that grows with friction",
    "s becomes z, dz/dx = (sgn(dx) - z) k/F, F the friction that is turned over",
    "short strokes see less friction than long ones, at a high load more so",
    pulls_alone,
    parameters,
    [](Numbers numbers, ForceValues& values) { values.presliding_N_m = numbers[0]; },
    nullptr,
    ForceEffect::Of::friction};

}  // namespace elastic_presliding

namespace load {

/// A third is the contact of bodies that yield. Friction that rises little as the load does is one
/// that does not depend on it.
Parameters parameters(const ForceScales& /*scales*/) {
  constexpr double kMost = 0.7;
  return {{"load_exponent", "1", -kMost, kMost, {0.1}}};
}

constexpr ForceEffect kEffect{
    "friction_load",
    "load-dependent friction",
    "mu (|T|/T_0)^-k",
    "friction relative to load falls as load rises, so that mu from light tests overstates the "
    "damage of heavy use",
    nullptr,
    parameters,
    [](Numbers numbers, ForceValues& values) { values.load_exponent = numbers[0]; },
    written<parameters>,
    ForceEffect::Of::friction};

}  // namespace load

namespace position {

Parameters parameters(const ForceScales& /*scales*/) {
  Parameters all;
  for (std::size_t harmonic = 1; harmonic <= ForceValues::kHarmonics; ++harmonic) {
    const std::string number = std::to_string(harmonic);
    all.push_back({"position_sine_" + number, "1", -1, 1, {0.01}});
    all.push_back({"position_cosine_" + number, "1", -1, 1, {0.01}});
  }
  return all;
}

/// a sin(k (x - m)) + b cos(k (x - m)) as a sum of sin(kx) and cos(kx); a table has six of them.
Extension about_zero(std::string_view id, Numbers numbers, const ForceScales& scales) {
  constexpr std::size_t kWritten = 6;
  Extension extension{std::string(id), {}};
  for (std::size_t harmonic = 1; harmonic <= kWritten; ++harmonic) {
    const std::size_t at = 2 * harmonic - 2;
    const double sine = at < numbers.size() ? numbers[at] : 0;
    const double cosine = at < numbers.size() ? numbers[at + 1] : 0;
    const double phase =
        2 * std::numbers::pi * static_cast<double>(harmonic) * scales.position_m / scales.stroke_m;
    const std::string number = std::to_string(harmonic);
    extension.values.push_back(
        {"position_sine_" + number, {sine * std::cos(phase) + cosine * std::sin(phase)}});
    extension.values.push_back(
        {"position_cosine_" + number, {cosine * std::cos(phase) - sine * std::sin(phase)}});
  }
  extension.values.push_back({"wavelength_m", {scales.stroke_m}});
  return extension;
}

constexpr ForceEffect kEffect{"friction_position",
                              "position-dependent friction",
                              "mu (1 + g(x)), F (1 + g(x))",
                              "damage gathers where the stroke meets more friction",
                              nullptr,
                              parameters,
                              [](Numbers numbers, ForceValues& values) {
                                std::ranges::copy(numbers, values.harmonics.begin());
                              },
                              about_zero,
                              ForceEffect::Of::friction};

}  // namespace position

namespace slack {

Parameters parameters(const ForceScales& scales) {
  return {slack_length(scales)};
}

constexpr ForceEffect kEffect{
    "slack",
    "backlash",
    "no friction within b of a reversal",
    "the tendon runs free at reversals, and shocks follow",
    works_both_ways,
    parameters,
    [](Numbers numbers, ForceValues& values) { values.slack_m = numbers[0]; },
    nullptr,
    ForceEffect::Of::friction};

}  // namespace slack

namespace loose_tendon {

Parameters parameters(const ForceScales& scales) {
  Parameters all{slack_length(scales),
                 {"slack_log_drop", "1", 0, 5, {0.1}, false, false, kLeastDrop},
                 {"slack_friction_share", "1", 0, 1, {1}}};
  all[1].beside = true;
  all[2].beside = true;
  return all;
}

constexpr ForceEffect kEffect{"slack",
                              "backlash",
                              "exp(-d) T, friction by another share, within b of a reversal",
                              "the tendon runs free at reversals, and shocks follow",
                              pulls_alone,
                              parameters,
                              [](Numbers numbers, ForceValues& values) {
                                values.loose_m = numbers[0];
                                values.loose_log_drop = numbers[1];
                                values.loose_friction = numbers[2];
                              },
                              nullptr,
                              ForceEffect::Of::friction};

}  // namespace loose_tendon

namespace compliance {

Parameters parameters(const ForceScales& scales) {
  return {stiffness("stiffness_N_m", scales, {3, 30, 300})};
}

constexpr ForceEffect kEffect{
    "compliance",
    "sheath and tendon elasticity",
    "dT_in = k dx within what friction holds",
    "reversals of the friction come late, which changes small cycles",
    nullptr,
    parameters,
    [](Numbers numbers, ForceValues& values) { values.stiffness_N_m = numbers[0]; },
    nullptr,
    ForceEffect::Of::friction};

}  // namespace compliance

namespace lag {

Parameters parameters(const ForceScales& scales) {
  return {{"lag_s", "s", -0.1, 0.1, {0.005, -0.005}, false, false, kOfStep * scales.step_s}};
}

constexpr ForceEffect kEffect{
    "filter_lag",
    "first-order lag of a sensor",
    "T_out + tau dT_out/dt; of the input where tau is negative",
    "peaks of fast cycles are read too low",
    nullptr,
    parameters,
    [](Numbers numbers, ForceValues& values) { values.lag_s = numbers[0]; },
    written<parameters>,
    ForceEffect::Of::time};

}  // namespace lag

namespace delay {

Parameters parameters(const ForceScales& scales) {
  return {{"delay_s",
           "s",
           -0.1,
           0.1,
           {0.005, -0.005, 0.02, -0.02},
           false,
           false,
           kOfStep * scales.step_s}};
}

constexpr ForceEffect kEffect{
    "channel_delay",
    "delay of a channel",
    "T_out(t + d); T_in(t + |d|) where d is negative",
    "nothing by itself: friction and lag are read wrong where it is not known",
    nullptr,
    parameters,
    [](Numbers numbers, ForceValues& values) { values.delay_s = numbers[0]; },
    nullptr,
    ForceEffect::Of::time};

}  // namespace delay

namespace zero {

Parameters parameters(const ForceScales& scales) {
  const double most_N = 2 * std::max(scales.force_N, scales.input_N);
  return {{"load_cell_zero_N", "N", -most_N, most_N, {0.01 * scales.force_N}}};
}

constexpr ForceEffect kEffect{
    "load_cell_zero",
    "zero of the output sensor",
    "T_out - b",
    "every tension is read too high or too low by the same force",
    nullptr,
    parameters,
    [](Numbers numbers, ForceValues& values) { values.zero_N = numbers[0]; },
    [](std::string_view id, Numbers numbers, const ForceScales& /*scales*/) {
      return Extension{std::string(id), {{"zero_N", {numbers[0]}}}};
    }};

}  // namespace zero

namespace temperature {

Parameters parameters(const ForceScales& /*scales*/) {
  return {{"temperature_coefficient_1_K", "1/K", -0.05, 0.05, {0.001}}};
}

constexpr ForceEffect kEffect{
    "friction_temperature",
    "temperature-dependent friction",
    "all friction (1 + k (T - 20 C))",
    "a sheath that is warmer has another friction, and damage goes with it",
    [](const ForceRecord& record) { return !record.sheath_temperature_C.empty(); },
    parameters,
    [](Numbers numbers, ForceValues& values) { values.temperature_1_K = numbers[0]; },
    written<parameters>,
    ForceEffect::Of::session};

}  // namespace temperature

namespace wear {

bool has_cycles(const ForceRecord& record) {
  return !record.cycle.empty();
}

Parameters parameters(const ForceScales& /*scales*/) {
  return {{"wear_coefficient", "1", -1, 1, {0.02}}, {"wear_exponent", "1", 0.1, 2, {1, 0.5}}};
}

constexpr ForceEffect kEffect{
    "friction_wear",
    "wear of the sheath",
    "mu (1 + a (n/1000)^p)",
    "friction grows with mu phi as the sheath wears, so that later cycles do more damage than "
    "Miner books for new ones",
    has_cycles,
    parameters,
    [](Numbers numbers, ForceValues& values) {
      values.wear = numbers[0];
      values.wear_exponent = numbers[1];
    },
    [](std::string_view id, Numbers numbers, const ForceScales& scales) {
      Extension extension = by_name(id, numbers, parameters(scales));
      extension.values.push_back({"run_in_cycles", {0}});
      return extension;
    },
    ForceEffect::Of::session};

}  // namespace wear

namespace run_in {

constexpr double kMost_cycles = 10000;

Parameters parameters(const ForceScales& scales) {
  return {{"wear_coefficient", "1", -1, 1, {0.05}},
          {"run_in_cycles",
           "cycles",
           1,
           std::clamp(2 * scales.cycles, 2.0, kMost_cycles),
           {0.03 * scales.cycles, 0.1 * scales.cycles, 0.3 * scales.cycles}}};
}

constexpr ForceEffect kEffect{
    "friction_wear",
    "run-in of the sheath",
    "mu (1 + a exp(-n/n0))",
    "a new sheath has another friction than one that has run, and its first cycles another damage",
    wear::has_cycles,
    parameters,
    [](Numbers numbers, ForceValues& values) {
      values.run_in = numbers[0];
      values.run_in_cycles = numbers[1];
    },
    [](std::string_view id, Numbers numbers, const ForceScales& scales) {
      Extension extension = by_name(id, numbers, parameters(scales));
      extension.values.insert(extension.values.begin() + 1, {"wear_exponent", {0}});
      return extension;
    },
    ForceEffect::Of::session};

}  // namespace run_in

namespace bend_angle {

/// A scale of all angles is one of mu: the largest is taken to be right.
Parameters parameters(const ForceScales& scales) {
  Parameters all;
  for (std::size_t pose = 0; pose + 1 < scales.poses_rad.size(); ++pose) {
    const int angle_deg =
        static_cast<int>(std::lround(scales.poses_rad[pose] * 180 / std::numbers::pi));
    all.push_back({"bend_angle_error_rad_at_" + std::to_string(angle_deg) + "_deg",
                   "rad",
                   -0.6,
                   0.6,
                   {0.02}});
  }
  return all;
}

constexpr ForceEffect kEffect{
    "bend_angle",
    "bend-angle (pose) error",
    "mu (phi + delta), delta of each pose",
    "a pose that bends more than it was said to has input tensions larger by exp(mu delta)",
    nullptr,
    parameters,
    [](Numbers numbers, ForceValues& values) { values.pose_errors_rad = numbers; },
    [](std::string_view id, Numbers numbers, const ForceScales& scales) {
      Extension::Value errors{"bend_angle_error_rad", {numbers.begin(), numbers.end()}};
      errors.values.push_back(0);
      Extension::Value angles{"bend_angles_deg", {}};
      for (const double pose_rad : scales.poses_rad) {
        angles.values.push_back(pose_rad * 180 / std::numbers::pi);
      }
      return Extension{std::string(id), {std::move(errors), std::move(angles)}};
    },
    ForceEffect::Of::session};

}  // namespace bend_angle

namespace current_offset {

Parameters parameters(const ForceScales& /*scales*/) {
  return {{"current_offset_A", "A", -0.5, 0.5, {0.01}}};
}

constexpr ForceEffect kEffect{
    "current_offset",
    "zero error of the current sensor",
    "I - b",
    "all input tensions are wrong by the same force: the mean moves and the amplitude stays",
    has_current,
    parameters,
    [](Numbers numbers, ForceValues& values) { values.current_offset_A = numbers[0]; },
    written<parameters>};

}  // namespace current_offset

namespace gear_asymmetry {

Parameters parameters(const ForceScales& /*scales*/) {
  return {{"gear_asymmetry", "1", -0.3, 0.3, {0.01}}};
}

constexpr ForceEffect kEffect{
    "gear_asymmetry",
    "direction-dependent gear efficiency",
    "eta_g (1 + c s)",
    "the amplitude of input tension is wrong by c times its mean, at every bend angle",
    has_current,
    parameters,
    [](Numbers numbers, ForceValues& values) { values.gear_asymmetry = numbers[0]; },
    written<parameters>};

}  // namespace gear_asymmetry

namespace torque_gain {

Parameters parameters(const ForceScales& /*scales*/) {
  return {{"droop_1_K", "1/K", 0, 0.005, {0.0005}}};
}

constexpr ForceEffect kEffect{
    "torque_gain",
    "torque constant that falls as the winding warms",
    "K_t (1 - alpha (T_winding - 20 C))",
    "a warm motor pulls less than its current says, so that damage is overstated by gamma alpha dT",
    [](const ForceRecord& record) {
      return has_current(record) && !record.winding_temperature_C.empty();
    },
    parameters,
    [](Numbers numbers, ForceValues& values) { values.droop_1_K = numbers[0]; },
    written<parameters>,
    ForceEffect::Of::session};

}  // namespace torque_gain

namespace torque_ripple {

Parameters parameters(const ForceScales& /*scales*/) {
  return {{"ripple_sine_A", "A", -0.5, 0.5, {0.01}},
          {"ripple_cosine_A", "A", -0.5, 0.5, {0.01}},
          {"ripple_harmonic",
           "1",
           1,
           24,
           {1, 2, 3, 4, 5, 6, 7, 8, 10, 12, 14, 16, 18, 21, 24},
           false,
           true}};
}

constexpr ForceEffect kEffect{
    "torque_ripple",
    "cogging and torque ripple",
    "I + a sin(k theta) + b cos(k theta)",
    "adds many small cycles of input tension, each of little damage",
    [](const ForceRecord& record) { return has_current(record) && !record.rotor_rad.empty(); },
    parameters,
    [](Numbers numbers, ForceValues& values) {
      values.ripple_sine_A = numbers[0];
      values.ripple_cosine_A = numbers[1];
      values.ripple_harmonic = numbers[2];
    },
    written<parameters>};

}  // namespace torque_ripple

namespace giving_sheath {

Parameters parameters(const ForceScales& /*scales*/) {
  return {{"giving_share", "1", -1, 1, {0.1}}};
}

constexpr ForceEffect kEffect{
    "giving_sheath",
    "a sheath that bends more or less under load",
    "phi (1 + c (|T|/T_0 - 1))",
    "",
    nullptr,
    parameters,
    [](Numbers numbers, ForceValues& values) { values.giving_share = numbers[0]; },
    nullptr,
    ForceEffect::Of::friction,
    true};

}  // namespace giving_sheath

namespace one_way_friction {

Parameters parameters(const ForceScales& /*scales*/) {
  return {{"one_way_share", "1", -0.9, 0.9, {0.1}}};
}

constexpr ForceEffect kEffect{
    "one_way_friction",
    "friction that is larger one way than the other",
    "all friction (1 + c s)",
    "",
    works_both_ways,
    parameters,
    [](Numbers numbers, ForceValues& values) { values.one_way_share = numbers[0]; },
    nullptr,
    ForceEffect::Of::friction,
    true};

}  // namespace one_way_friction

namespace bent_sensor {

Parameters parameters(const ForceScales& /*scales*/) {
  return {{"bent_share", "1", -0.5, 0.5, {0.01}}};
}

constexpr ForceEffect kEffect{
    "bent_sensor",
    "a sensor of the output that is not linear",
    "T_out (1 + c (T_out/T_0)^2)",
    "",
    nullptr,
    parameters,
    [](Numbers numbers, ForceValues& values) { values.bent_share = numbers[0]; },
    nullptr,
    ForceEffect::Of::sensor,
    true};

}  // namespace bent_sensor

using Effects = std::array<ForceEffect, kForceTermCount>;

/// In order of ForceTerm.
constexpr Effects kEffects{preload::kEffect,
                           velocity::kEffect,
                           presliding::kEffect,
                           elastic_presliding::kEffect,
                           stribeck::kEffect,
                           load::kEffect,
                           position::kEffect,
                           slack::kEffect,
                           loose_tendon::kEffect,
                           compliance::kEffect,
                           lag::kEffect,
                           delay::kEffect,
                           zero::kEffect,
                           temperature::kEffect,
                           wear::kEffect,
                           run_in::kEffect,
                           bend_angle::kEffect,
                           current_offset::kEffect,
                           gear_asymmetry::kEffect,
                           torque_gain::kEffect,
                           torque_ripple::kEffect,
                           giving_sheath::kEffect,
                           one_way_friction::kEffect,
                           bent_sensor::kEffect};

}  // namespace

const ForceEffect& definition_of(ForceTerm term) {
  return kEffects[static_cast<std::size_t>(term)];
}

bool is_shown(ForceTerm term, std::span<const ForceRecord> records) {
  const auto shown = definition_of(term).shown;
  return shown == nullptr || std::ranges::all_of(records, shown);
}

std::vector<ForceParameter> parameters_of(ForceTerm term, const ForceScales& scales) {
  return definition_of(term).parameters(scales);
}

std::vector<ForceParameter> parameters_of(const ForceTerms& terms, const ForceScales& scales) {
  std::vector<ForceParameter> all{{"gain", "1", 0.05, 20, {1}},
                                  {"friction_coefficient", "1", 0, 2, {0.1}}};
  for (const ForceTerm term : terms) {
    for (ForceParameter& parameter : parameters_of(term, scales)) {
      all.push_back(std::move(parameter));
    }
  }
  return all;
}

std::span<const double> parameters_at(std::size_t place, const ForceTerms& terms,
                                      std::span<const double> parameters,
                                      const ForceScales& scales) {
  std::size_t first = 2;
  for (std::size_t i = 0; i < place; ++i) {
    first += parameters_of(terms[i], scales).size();
  }
  return parameters.subspan(first, parameters_of(terms[place], scales).size());
}

std::optional<Extension> written_term(ForceTerm term, std::span<const double> parameters,
                                      const ForceScales& scales) {
  const ForceEffect& effect = definition_of(term);
  if (effect.written == nullptr) {
    return std::nullopt;
  }
  return effect.written(effect.id, parameters, scales);
}

double written_friction(double friction, std::span<const Extension> extensions,
                        const ForceScales& scales) {
  constexpr double kReference_N = 50;
  const Extension* const load = extension_of(extensions, "friction_load");
  return load == nullptr ? friction
                         : friction * std::pow(kReference_N / scales.force_N,
                                               -value_of(*load, "load_exponent"));
}

}  // namespace host_sim::diagnose
