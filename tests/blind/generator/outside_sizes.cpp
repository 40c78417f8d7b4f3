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

}  // namespace

std::span<const SizedEffect> outside_effects() {
  static const std::vector<SizedEffect> effects{
      {"humidity_cycle", Needs::any_input, humidity_cycle},
      {"load_cell_cross_talk", Needs::load_cell, load_cell_cross_talk},
      {"load_cell_thermal_lag", Needs::load_cell, load_cell_thermal_lag},
      {"rotor_inertia", Needs::motor_current, rotor_inertia},
      {"sheath_creep", Needs::any_input, sheath_creep},
      {"stick_slip", Needs::any_input, stick_slip},
      {"tension_dependent_bend", Needs::any_input, tension_dependent_bend}};
  return effects;
}

}  // namespace blind
