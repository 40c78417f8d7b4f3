#include <vector>

#include "tests/blind/generator/sized_effect.hpp"

namespace blind {
namespace {

HiddenEffect sheath_creep(const TensionScales& /*scales*/, Dice& dice) {
  return {"sheath_creep",
          true,
          {{"share", {dice.sign() * dice.log_between(0.03, 0.15)}},
           {"time_constant_s", {dice.log_between(2, 10)}}},
          {}};
}

HiddenEffect stick_slip(const TensionScales& /*scales*/, Dice& dice) {
  return {"stick_slip",
          true,
          {{"share", {dice.log_between(0.3, 1.5)}},
           {"bursts_per_min", {dice.between(6, 20)}},
           {"burst_s", {dice.between(0.5, 2)}},
           {"frequency_Hz", {dice.between(4, 15)}}},
          {}};
}

HiddenEffect load_cell_cross_talk(const TensionScales& /*scales*/, Dice& dice) {
  return {"load_cell_cross_talk",
          true,
          {{"sensitivity_N_s_rad", {dice.sign() * dice.log_between(4, 20)}}},
          {}};
}

HiddenEffect humidity_cycle(const TensionScales& /*scales*/, Dice& dice) {
  return {"humidity_cycle",
          true,
          {{"share", {dice.log_between(0.15, 0.5)}},
           {"period_h", {dice.between(6, 24)}},
           {"phase_deg", {dice.between(0, 360)}}},
          {}};
}

HiddenEffect tension_dependent_bend(const TensionScales& scales, Dice& dice) {
  return {"tension_dependent_bend",
          true,
          {{"share_1_N", {dice.sign() * dice.log_between(0.004, 0.015)}},
           {"reference_N", {scales.mean_tension_N}}},
          {}};
}

HiddenEffect load_cell_thermal_lag(const TensionScales& /*scales*/, Dice& dice) {
  return {"load_cell_thermal_lag",
          true,
          {{"drift_N_K", {dice.sign() * dice.log_between(0.05, 0.25)}},
           {"time_constant_s", {dice.log_between(5, 40)}},
           {"reference_C", {20}}},
          {}};
}

HiddenEffect rotor_inertia(const TensionScales& /*scales*/, Dice& dice) {
  return {"rotor_inertia", true, {{"inertia_g_cm2", {dice.log_between(4, 40)}}}, {}};
}

HiddenEffect gain_drift(const TensionScales& /*scales*/, Dice& dice) {
  return {"gain_drift", true, {{"log_per_min_sd", {dice.log_between(0.1, 0.5)}}}, {}};
}

HiddenEffect soft_saturation(const TensionScales& scales, Dice& dice) {
  return {"soft_saturation",
          true,
          {{"limit_N", {scales.mean_tension_N * dice.log_between(2.5, 6)}}},
          {}};
}

HiddenEffect load_cell_hysteresis(const TensionScales& scales, Dice& dice) {
  return {"load_cell_hysteresis",
          true,
          {{"share", {dice.between(0.3, 0.8)}},
           {"widest_N", {scales.mean_tension_N * dice.log_between(0.1, 0.4)}}},
          {}};
}

HiddenEffect resonance(const TensionScales& /*scales*/, Dice& dice) {
  return {"resonance",
          true,
          {{"frequency_Hz", {dice.log_between(4, 15)}}, {"damping", {dice.log_between(0.03, 0.2)}}},
          {}};
}

HiddenEffect velocity_steps(const TensionScales& scales, Dice& dice) {
  return {"velocity_steps",
          true,
          {{"step_mm_s", {1e3 * scales.fastest_m_s * dice.log_between(0.05, 0.3)}}},
          {}};
}

HiddenEffect friction_acceleration(const TensionScales& scales, Dice& dice) {
  return {"friction_acceleration",
          true,
          {{"share_s2_m", {dice.sign() * dice.log_between(0.3, 1) / scales.fastest_m_s2}}},
          {}};
}

HiddenEffect dwell_friction(const TensionScales& /*scales*/, Dice& dice) {
  return {"dwell_friction",
          true,
          {{"share", {dice.log_between(1, 5)}},
           {"time_constant_s", {dice.log_between(0.1, 1)}},
           {"length_mm", {dice.log_between(0.5, 3)}}},
          {}};
}

}  // namespace

std::span<const SizedEffect> outside_effects() {
  static const std::vector<SizedEffect> effects{
      {"gain_drift", Needs::any_input, gain_drift},
      {"humidity_cycle", Needs::any_input, humidity_cycle},
      {"load_cell_cross_talk", Needs::load_cell, load_cell_cross_talk},
      {"load_cell_thermal_lag", Needs::load_cell, load_cell_thermal_lag},
      {"rotor_inertia", Needs::motor_current, rotor_inertia},
      {"sheath_creep", Needs::any_input, sheath_creep},
      {"soft_saturation", Needs::any_input, soft_saturation},
      {"stick_slip", Needs::any_input, stick_slip},
      {"tension_dependent_bend", Needs::any_input, tension_dependent_bend}};
  return effects;
}

std::span<const SizedEffect> held_back_effects() {
  static const std::vector<SizedEffect> effects{
      {"dwell_friction", Needs::any_input, dwell_friction},
      {"friction_acceleration", Needs::any_input, friction_acceleration},
      {"load_cell_hysteresis", Needs::load_cell, load_cell_hysteresis},
      {"resonance", Needs::any_input, resonance},
      {"velocity_steps", Needs::any_input, velocity_steps}};
  return effects;
}

}  // namespace blind
