#include "host_sim/synth/two_sided/kinds.hpp"

namespace host_sim::synth {
namespace {

bool at_output(const Values& values) {
  return values.choice("sensor") == "output_tension";
}

}  // namespace

std::span<const TwoSidedKind> two_sided_kinds() {
  static const Choice kSensor{"sensor", {"output_tension", "input_tension", "motor_current"}};
  static const std::vector<TwoSidedKind> kinds{
      {"friction_velocity",
       {{{"viscous_N_s_m", "N_s_m", {0, 1e5}}}},
       {},
       [](const Values& values, TwoSidedEffects& effects) {
         effects.viscous_N_s_m = values["viscous_N_s_m"];
       }},
      {"presliding",
       {{{"length_mm", "mm", {0.001, 1000}}}},
       {},
       [](const Values& values, TwoSidedEffects& effects) {
         effects.presliding_m = values["length_mm"] * 1e-3;
       }},
      {"friction_load",
       {{{"exponent", "", {-1, 0.9}}}, {{"reference_N", "N", {0.001, 1e6}}}},
       {},
       [](const Values& values, TwoSidedEffects& effects) {
         effects.load_exponent = values["exponent"];
         effects.load_reference_N = values["reference_N"];
       }},
      {"friction_preload",
       {{{"force_N", "N", {0, 1e6}}}},
       {},
       [](const Values& values, TwoSidedEffects& effects) {
         effects.preload_N = values["force_N"];
       }},
      {"friction_position",
       {{{"change", "", {-0.9, 5}}},
        {{"centre_mm", "mm", {-1e6, 1e6}}},
        {{"width_mm", "mm", {0.1, 1000}}}},
       {},
       [](const Values& values, TwoSidedEffects& effects) {
         effects.bump = values["change"];
         effects.bump_centre_m = values["centre_mm"] * 1e-3;
         effects.bump_width_m = values["width_mm"] * 1e-3;
       }},
      {"slack",
       {{{"dead_zone_mm", "mm", {0.001, 1000}}}},
       {},
       [](const Values& values, TwoSidedEffects& effects) {
         effects.play_m = values["dead_zone_mm"] * 1e-3;
       }},
      {"compliance",
       {{{"stiffness_N_mm", "N_mm", {0.1, 1e5}}}},
       {},
       [](const Values& values, TwoSidedEffects& effects) {
         effects.stiffness_N_m = values["stiffness_N_mm"] * 1e3;
       }},
      {"load_cell_zero",
       {{{"zero_N", "N", {-1e6, 1e6}}}},
       {},
       [](const Values& values, TwoSidedEffects& effects) {
         effects.output_zero_N = values["zero_N"];
       }},
      {"filter_lag",
       {{{"time_constant_ms", "ms", {0.01, 1000}}}},
       {kSensor},
       [](const Values& values, TwoSidedEffects& effects) {
         (at_output(values) ? effects.output_lag_s : effects.input_lag_s) =
             values["time_constant_ms"] * 1e-3;
       }},
      {"channel_delay",
       {{{"delay_ms", "ms", {0.01, 1000}}}},
       {kSensor},
       [](const Values& values, TwoSidedEffects& effects) {
         (at_output(values) ? effects.output_delay_s : effects.input_delay_s) =
             values["delay_ms"] * 1e-3;
       }},
  };
  return kinds;
}

std::span<const TwoSidedKind> outside_two_sided_kinds() {
  static const std::vector<TwoSidedKind> kinds{
      {"sheath_creep",
       {{{"share", "", {-0.5, 0.5}}}, {{"time_constant_s", "s", {0.1, 1e5}}}},
       {},
       [](const Values& values, TwoSidedEffects& effects) {
         effects.creep = values["share"];
         effects.creep_time_s = values["time_constant_s"];
       }},
      {"moving_mass",
       {{{"mass_kg", "kg", {0, 1e4}}}},
       {},
       [](const Values& values, TwoSidedEffects& effects) {
         effects.moved_kg = values["mass_kg"];
       }},
      {"one_way_friction",
       {{{"share", "", {-0.9, 5}}}},
       {},
       [](const Values& values, TwoSidedEffects& effects) { effects.one_way = values["share"]; }},
  };
  return kinds;
}

}  // namespace host_sim::synth
